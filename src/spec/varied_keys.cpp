// SPDX-License-Identifier: Apache-2.0
#include "varied_keys.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "ideotype/core/contract.hpp"
#include "spec/nodes.hpp"
#include "spec/tables.hpp"
#include "spec/values.hpp"
#include "spec/writer.hpp"

namespace ideotype {

namespace {

const VariableKey* find(const std::vector<VariableKey>& keys,
                        const std::string& name) {
    const auto variable = std::ranges::find(keys, name, &VariableKey::name);
    return variable == keys.end() ? nullptr : &*variable;
}

//! Removes the items of a list, to which reading would append others.
void clear_list(const Target& target) {
    if (auto* const* dates = std::get_if<std::vector<Date>*>(&target))
        (*dates)->clear();
    if (auto* const* points = std::get_if<std::vector<glm::dvec2>*>(&target))
        (*points)->clear();
}

//! Reads a value into all tables of a key.
void read_into(const VariableKey& variable, const KnownNames& known,
               const std::string& text, const Problems& problems) {
    const toml::table parsed = toml::parse("value = " + text);
    const toml::node& node = *parsed.get("value");
    const auto read = [&](const Target& target, const toml::node& value) {
        clear_list(target);
        ideotype::read_value(value, variable.section,
                             {variable.key.key, target}, known, problems);
    };
    const auto* date = std::get_if<Date*>(&variable.key.value);
    read(variable.key.value, node);
    for (const Target& other : variable.others) {
        if (!date) {
            read(other, node);
            continue;
        }
        Date& own = *std::get<Date*>(other);
        own = in_year(**date, own.year);
    }
}

//! Returns whether values are numbers or dates, which are in order.
bool is_ordered(const BoundKey& key) {
    if (std::holds_alternative<Date*>(key.value)) return true;
    if (const auto* dates = std::get_if<std::vector<Date>*>(&key.value))
        return (*dates)->size() == 1;
    const auto numbers = numbers_of(key);
    return numbers && numbers->size() == 1;
}

//! Returns a campaign with densities, since resolved texts have only distances.
//! They are rounded, so that the distance that follows from a density has this
//! density.
Spec with_densities(Spec spec) {
    for (auto& [name, spacing] : spec.spacings)
        if (spacing.row > 0 && spacing.plant > 0)
            spacing.density =
                std::stod(fmt::format("{:.12g}", spacing.plants_per_area()));
    return spec;
}

//! Completes a varied key that lists values: sorts them if they are in order,
//! and finds that of the campaign.
void complete_values(const Spec& spec, const VariableKey& variable,
                     KeyFactor& factor) {
    std::vector<std::pair<double, TomlValue>> sorted;
    bool has_order = true;
    for (const TomlValue& each : factor.values) {
        Spec scratch = spec;
        const std::vector<VariableKey> keys = variable_keys(scratch);
        const VariableKey& key = *find(keys, factor.key);
        const Problems problems(spec.name);
        read_into(key, names_of(spec.plant.crop), each.text, problems);
        // Checks report unreadable values.
        if (!problems.empty()) return;
        has_order = has_order && is_ordered(key.key);
        const auto numbers = numbers_of(key.key);
        sorted.emplace_back(
            numbers && numbers->size() == 1 ? numbers->front() : 0.0,
            TomlValue{toml_text(key.key)});
    }
    // Texts of dates are in the order of dates.
    if (has_order)
        std::ranges::stable_sort(sorted, [](const auto& a, const auto& b) {
            return std::pair(a.first, a.second.text) <
                   std::pair(b.first, b.second.text);
        });
    factor.kind = has_order ? GeneKind::integer : GeneKind::choice;
    factor.values.clear();
    for (const auto& [number, value] : sorted) factor.values.push_back(value);
    const std::string now = toml_text(variable.key);
    const auto entry = std::ranges::find(factor.values, TomlValue{now});
    factor.is_known = now.empty() || entry != factor.values.end();
    if (entry != factor.values.end())
        factor.number = static_cast<double>(entry - factor.values.begin());
}

//! Removes the capacity of leaves if their rate in full light varies, and the
//! reverse, since each follows from the other.
void drop_other_capacity(const BoundKey& varied, PhotosynthesisSpec& leaves) {
    const auto* const numbers =
        std::get_if<std::vector<double>*>(&varied.value);
    if (!numbers) return;
    if (*numbers == &leaves.amax) leaves.rate_2000.clear();
    if (*numbers == &leaves.rate_2000) leaves.amax.clear();
}

}  // namespace

std::vector<VariableKey> variable_keys(Spec& spec) {
    std::vector<VariableKey> keys;
    const auto add = [&](const Description& description, void* record,
                         const std::string& prefix) {
        for (const Table& table : description.tables()) {
            const std::size_t count = table.size(record);
            if (count == 0) continue;
            const std::string section = prefix + table.name;
            const bool is_there = !table.is_written || table.is_written(record);
            const bool is_shared =
                std::ranges::count(spec.objective.over, table.name) > 0;
            for (const Key& key : table.description->keys()) {
                const Form form = key.values.form;
                if (form == Form::name || form == Form::path ||
                    form == Form::source ||
                    !(table.is_variable || key.is_variable))
                    continue;
                std::vector<Target> others;
                for (std::size_t i = 1; i < count; ++i)
                    others.push_back(key.place(table.at(record, i)));
                keys.push_back({section,
                                section + '.' + key.name,
                                {key, key.place(table.at(record, 0))},
                                std::move(others),
                                is_there,
                                is_shared,
                                table.keeps_light});
            }
        }
    };
    add(spec_table, &spec, "");
    if (spec.plant.crop.is_known)
        add(crop_table, &spec.plant.crop, "plant.baseline.");
    return keys;
}

bool is_alike(const VariableKey& variable) {
    const auto* date = std::get_if<Date*>(&variable.key.value);
    const std::string first = toml_text(variable.key);
    return std::ranges::all_of(variable.others, [&](const Target& other) {
        if (date) {
            const Date& own = *std::get<Date*>(other);
            return own == in_year(**date, own.year);
        }
        return toml_text({variable.key.key, other}) == first;
    });
}

std::string value_in(const Spec& spec, const std::string& key) {
    Spec scratch = with_densities(spec);
    return toml_text(find(variable_keys(scratch), key)->key);
}

void try_value(const Spec& spec, const std::string& key, const TomlValue& value,
               const Problems& problems) {
    Spec scratch = spec;
    const std::vector<VariableKey> keys = variable_keys(scratch);
    read_into(*find(keys, key), names_of(spec.plant.crop), value.text,
              problems);
}

std::string text_of(const KeyFactor& factor, double number) {
    if (factor.values.empty()) return fmt::format("{}", number);
    const Range entries = bounds_of(factor);
    const double entry =
        std::clamp(std::round(number), entries.lower, entries.upper);
    return factor.values.at(static_cast<std::size_t>(entry)).text;
}

void set_keys(Spec& spec, const std::vector<KeyFactor>& factors,
              std::span<const double> numbers) {
    IDEOTYPE_EXPECT(factors.size() == numbers.size());
    for (Named<Spacing>& spacing : spec.spacings) spacing.value.density = 0;
    const std::vector<VariableKey> keys = variable_keys(spec);
    const KnownNames known = names_of(spec.plant.crop);
    const Problems problems(spec.name);
    for (const KeyFactor& factor : factors) {
        const VariableKey* const variable = find(keys, factor.key);
        IDEOTYPE_EXPECT(variable);
        drop_other_capacity(variable->key, spec.plant.crop.photosynthesis);
    }
    for (std::size_t i = 0; i < factors.size(); ++i)
        read_into(*find(keys, factors[i].key), known,
                  text_of(factors[i], numbers[i]), problems);
    problems.throw_if_any();
    // A varied density determines the distance in the row.
    for (Named<Spacing>& spacing : spec.spacings)
        spacing.value.follow_density();
}

std::vector<double> tried_numbers(const KeyFactor& factor) {
    const auto [lower, upper] = bounds_of(factor);
    constexpr double few = 32, inner = 0.382;
    std::vector<double> numbers{lower, upper};
    if (factor.kind == GeneKind::real)
        numbers.push_back(std::lerp(lower, upper, inner));
    else if (!factor.values.empty() || upper - lower < few)
        for (double number = lower + 1; number < upper; ++number)
            numbers.push_back(number);
    else
        numbers.push_back(std::round(std::lerp(lower, upper, inner)));
    return numbers;
}

void complete_factors(Spec& spec) {
    if (spec.search.keys.empty() && spec.sensitivity.keys.empty()) return;
    Spec scratch = with_densities(spec);
    const std::vector<VariableKey> keys = variable_keys(scratch);
    for (std::vector<KeyFactor>* factors :
         {&spec.search.keys, &spec.sensitivity.keys})
        for (KeyFactor& factor : *factors) {
            const VariableKey* const variable = find(keys, factor.key);
            if (!variable) continue;
            const char* const unit = variable->key.key.values.unit;
            factor.unit = *unit ? unit : "1";
            if (!factor.values.empty()) {
                complete_values(spec, *variable, factor);
                continue;
            }
            const auto numbers = numbers_of(variable->key);
            if (!numbers || numbers->size() > 1) continue;
            const bool is_whole = is_integer(variable->key);
            factor.kind = is_whole ? GeneKind::integer : GeneKind::real;
            const double middle = (factor.range.lower + factor.range.upper) / 2;
            factor.number = !numbers->empty() ? numbers->front()
                            : is_whole        ? std::floor(middle)
                                              : middle;
        }
}

}  // namespace ideotype
