// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "campaign/checks/checks.hpp"
#include "schema.hpp"

namespace ideotype {

namespace {

//! A key of the campaign, under its name in --set.
struct NamedKey {
    std::string section;  //!< section name for messages
    std::string name;
    Key key;
    std::size_t tables;  //!< number of tables of this kind
    bool is_there;       //!< whether the campaign has the key
};

constexpr const char* plant_prefix = "plant.baseline.";

//! Returns keys of the tables that describe the surroundings of plants.
std::vector<NamedKey> variable_keys(Draft& draft) {
    std::vector<NamedKey> keys;
    const auto add = [&](const std::vector<Table>& tables,
                         const std::string& prefix,
                         const std::set<std::string>& kinds) {
        for (const Table& table : tables) {
            if (!kinds.contains(table.name) || table.size() == 0) continue;
            const std::string name = prefix + table.name;
            for (const Key& key : table.section(0).keys)
                keys.push_back({name, name + '.' + key.name, key, table.size(),
                                !table.is_default});
        }
    };
    add(campaign_tables(draft), "",
        {"field", "spacing", "panel", "optics", "photosynthesis"});
    if (draft.is_crop_known)
        add(plant_tables(draft), plant_prefix,
            {"stalk", "sheath", "petiole", "blade", "organ", "leaf"});
    return keys;
}

//! Returns the numbers of a key; nothing if its value is not numeric.
std::optional<std::vector<double>> numbers_of(const Key& key) {
    if (key.is_clock() || key.is_duration()) return std::nullopt;
    if (const auto* number = std::get_if<double*>(&key.value))
        return std::vector{**number};
    const auto* list = std::get_if<std::vector<double>*>(&key.value);
    if (list && key.count == any_count) return **list;
    return std::nullopt;
}

std::string advice(const std::string& name, const std::vector<NamedKey>& keys) {
    std::vector<std::string> known;
    for (const NamedKey& each : keys)
        if (each.is_there && each.tables == 1 && numbers_of(each.key))
            known.push_back(each.name);
    const std::string nearest =
        name == "spacing.density" ? "spacing.plant" : nearest_name(name, known);
    return nearest.empty() ? "name a number of field, spacing, panel, optics, "
                             "photosynthesis or plant.baseline"
                           : "did you mean \"" + nearest + "\"?";
}

//! Returns the reason why a key cannot be varied, or "".
std::string fault(const NamedKey& found) {
    if (found.name == "spacing.density")
        return "(which is told by the distance between plants)";
    if (!found.is_there)
        return fmt::format("(this campaign has no [{}])", found.section);
    if (found.tables > 1)
        return fmt::format("(there are {} tables [[{}]])", found.tables,
                           found.section);
    const auto numbers = numbers_of(found.key);
    if (!numbers)
        return fmt::format("(of type {}; only decimal numbers vary)",
                           found.key.type);
    if (numbers->size() > 1)
        return fmt::format("(which has {} values)", numbers->size());
    return "";
}

//! Returns whether a range lies within that of its key, or reports a fault.
//! @param problems problems of the factor
bool is_in_range(const KeyFactor& factor, const NamedKey& found,
                 const Problems& problems) {
    for (const double bound : {factor.range.lower, factor.range.upper}) {
        const std::string what = fault_of(bound, found.section, found.key);
        if (what.empty()) continue;
        problems.add("range", what);
        return false;
    }
    return true;
}

//! @param table name of the table of the study or search
//! @param problems problems of the factor
void check_key(const std::string& table, KeyFactor& factor,
               const std::vector<NamedKey>& keys, const Problems& problems) {
    const auto found = std::ranges::find(keys, factor.key, &NamedKey::name);
    const std::string what = found == keys.end()
                                 ? "(which is no numeric key of this campaign)"
                                 : fault(*found);
    if (!what.empty())
        return problems.add("key", "{}.keys has \"{}\" {}; {}", table,
                            factor.key, what, advice(factor.key, keys));
    if (!problems.usable({"range"}) || !is_in_range(factor, *found, problems))
        return;
    const std::vector<double> numbers = *numbers_of(found->key);
    const auto& [lower, upper] = factor.range;
    const std::string& unit = found->key.unit;
    factor.unit = unit.empty() ? "1" : unit;
    factor.value = numbers.empty() ? (lower + upper) / 2 : numbers.front();
}

void check_keys(const std::string& table, std::vector<KeyFactor>& factors,
                Draft& draft, const Problems& problems) {
    std::set<std::string> seen;
    const std::vector<NamedKey> keys = variable_keys(draft);
    for (std::size_t i = 0; i < factors.size(); ++i) {
        KeyFactor& factor = factors[i];
        const Problems own = problems.in(table).in("keys", i);
        // Without its crop file, nothing is known about the plant.
        if (!own.usable({"key"}) ||
            (!draft.is_crop_known && factor.key.starts_with(plant_prefix)))
            continue;
        if (seen.insert(factor.key).second)
            check_key(table, factor, keys, own);
        else
            own.add("key",
                    "{}.keys has \"{}\" twice (once is enough); remove one",
                    table, factor.key);
    }
}

}  // namespace

void check_sensitivity(Draft& draft, const Problems& problems) {
    const Problems own = problems.in("sensitivity");
    const Variation& varied = draft.varied;
    const int levels = draft.design.levels;
    if (own.usable({"levels"}) && levels % 2 != 0)
        own.add("levels",
                "sensitivity.levels is {} (a step of the design is half of all "
                "levels); use {}",
                levels, levels + 1);
    if (own.usable({"traits"}) && !varied.has_traits && varied.keys.empty() &&
        draft.is_study)
        own.add("traits",
                "sensitivity.traits is false (and there are no "
                "sensitivity.keys, so nothing would vary); name a key, or "
                "leave it out");
    check_keys("sensitivity", draft.varied.keys, draft, problems);
    check_keys("search", draft.searched, draft, problems);
}

void set_key(Draft& draft, const KeyFactor& factor, double value) {
    for (const NamedKey& each : variable_keys(draft)) {
        if (each.name != factor.key) continue;
        if (const auto* number = std::get_if<double*>(&each.key.value))
            **number = value;
        else
            *std::get<std::vector<double>*>(each.key.value) = {value};
    }
}

}  // namespace ideotype
