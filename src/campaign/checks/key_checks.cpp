// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "campaign/checks/checks.hpp"
#include "spec/section.hpp"
#include "spec/varied_keys.hpp"

namespace ideotype {

namespace {

std::string advice(const std::string& name,
                   const std::vector<VariableKey>& keys) {
    std::vector<std::string> known;
    for (const VariableKey& each : keys)
        if (each.is_there && each.tables == 1 && numbers_of(each.key))
            known.push_back(each.name);
    const std::string nearest =
        name == "spacing.density" ? "spacing.plant" : nearest_name(name, known);
    return nearest.empty() ? "name a number of field, spacing, panel, optics, "
                             "photosynthesis or plant.baseline"
                           : "did you mean \"" + nearest + "\"?";
}

//! Returns the reason why a key cannot be varied, or "".
std::string fault(const VariableKey& variable) {
    if (variable.name == "spacing.density")
        return "(which follows from spacing.plant)";
    if (!variable.is_there)
        return fmt::format("(this campaign has no [{}])", variable.section);
    if (variable.tables > 1)
        return fmt::format("(there are {} tables [[{}]])", variable.tables,
                           variable.section);
    const auto numbers = numbers_of(variable.key);
    if (!numbers)
        return fmt::format("(of type {}; only decimal numbers vary)",
                           variable.key.key.values.type);
    if (numbers->size() > 1)
        return fmt::format("(which has {} values)", numbers->size());
    return "";
}

//! @param table name of the table of the study or search
//! @param problems problems of the factor
void check_key(const std::string& table, const KeyFactor& factor,
               const std::vector<VariableKey>& keys, const Problems& problems) {
    const auto variable =
        std::ranges::find(keys, factor.key, &VariableKey::name);
    const std::string reason =
        variable == keys.end() ? "(which is not a numeric key of this campaign)"
                               : fault(*variable);
    problems.rule(ProblemCode::unknown_name, {"key"}, !reason.empty(),
                  "{}.keys has \"{}\" {}; {}", table, factor.key, reason,
                  advice(factor.key, keys));
    for (const double bound : {factor.range.lower, factor.range.upper})
        problems.rule(
            {"range", "key"},
            [&] {
                return fault_of(bound, variable->section, variable->key.key);
            },
            ProblemCode::out_of_range);
}

void check_keys(const std::string& table, const std::vector<KeyFactor>& factors,
                const Spec& spec, const Problems& problems) {
    if (factors.empty()) return;
    std::set<std::string> seen;
    Spec varied = spec;
    const std::vector<VariableKey> keys = variable_keys(varied);
    for (std::size_t i = 0; i < factors.size(); ++i) {
        const KeyFactor& factor = factors[i];
        // If a crop could not be read, its keys are unknown.
        if (!spec.plant.crop.is_known &&
            factor.key.starts_with("plant.baseline."))
            continue;
        const Problems of_factor = problems.in(table).in("keys", i);
        of_factor.rule(
            ProblemCode::duplicate, {"key"},
            [&] { return !seen.insert(factor.key).second; },
            "{}.keys has \"{}\" twice (once is enough); remove one", table,
            factor.key);
        check_key(table, factor, keys, of_factor);
    }
}

}  // namespace

void check_sensitivity(const Spec& spec, const Problems& problems) {
    const Problems of_study = problems.in("sensitivity");
    const int levels = spec.sensitivity.levels;
    of_study.rule(
        {"levels"}, levels % 2 != 0,
        "sensitivity.levels is {} (a step of the design is half of all "
        "levels); use {}",
        levels, levels + 1);
    of_study.rule(
        {"traits"},
        spec.is_study && !spec.sensitivity.has_traits &&
            spec.sensitivity.keys.empty(),
        "sensitivity.traits is false (and there are no sensitivity.keys, "
        "so nothing would vary); name a key, or leave it out");
    check_keys("sensitivity", spec.sensitivity.keys, spec, problems);
    check_keys("search", spec.search.keys, spec, problems);
}

}  // namespace ideotype
