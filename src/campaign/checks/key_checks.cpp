// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
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
        if (each.is_there && (each.tables() == 1 || each.is_shared))
            known.push_back(each.name);
    const std::string nearest = nearest_name(name, known);
    return nearest.empty()
               ? "name a key of field, spacing, panel, optics, photosynthesis, "
                 "water, soil, irrigation or plant.baseline"
               : "did you mean \"" + nearest + "\"?";
}

//! Returns the reason why a key cannot be varied, or "".
std::string fault(const VariableKey& variable) {
    if (!variable.is_there)
        return fmt::format("(this campaign has no [{}])", variable.section);
    if (variable.tables() > 1 && !variable.is_shared)
        return fmt::format("(there are {} tables [[{}]])", variable.tables(),
                           variable.section);
    if (!is_alike(variable))
        return fmt::format(
            "(the scenarios of [[{}]] differ in it, but would all have the "
            "varied value)",
            variable.section);
    return "";
}

//! Returns the reason why the key cannot be varied in a range, or "".
std::string fault_of_range(const VariableKey& variable) {
    const auto numbers = numbers_of(variable.key);
    if (!numbers)
        return fmt::format("(of type {}; only numbers have a range)",
                           variable.key.key.values.type);
    if (numbers->size() > 1)
        return fmt::format("(which has {} values)", numbers->size());
    return "";
}

void check_range(const std::string& table, const KeyFactor& factor,
                 const VariableKey& variable, const Problems& problems) {
    problems.rule(
        {"range", "values", "key"}, !(factor.range.lower < factor.range.upper),
        "{}.keys does not say how {} varies (there is no range and there are "
        "no values); add {}",
        table, factor.key,
        fault_of_range(variable).empty() ? "range = [lower, upper]"
                                         : "values = [one, another]");
    problems.rule(
        ProblemCode::wrong_type, {"range", "key"},
        [&] { return !fault_of_range(variable).empty(); },
        "{}.keys has a range of \"{}\" {}; list values = [one, another]", table,
        factor.key, fault_of_range(variable));
    const auto [lower, upper] = factor.range;
    problems.rule(
        ProblemCode::wrong_type, {"range", "key"},
        is_integer(variable.key) &&
            (lower != std::round(lower) || upper != std::round(upper)),
        "{}.keys: the range of {} is [{}, {}] (but its values are whole "
        "numbers); use [{}, {}]",
        table, factor.key, lower, upper, std::ceil(lower), std::floor(upper));
    for (const double bound : {lower, upper})
        problems.rule(
            {"range", "key"},
            [&] { return fault_of(bound, variable.section, variable.key.key); },
            ProblemCode::out_of_range);
}

//! Reports values that the key does not accept, or that are given twice.
void check_values(const std::string& table, const KeyFactor& factor,
                  const Spec& spec, const Problems& problems) {
    problems.rule({"values", "key"}, factor.values.size() < 2,
                  "{}.keys has a single value of {} (so nothing would vary); "
                  "add another, or remove the table",
                  table, factor.key);
    std::set<std::string> seen;
    for (const TomlValue& value : factor.values) {
        const Problems problems_of_value(spec.name);
        try_value(spec, factor.key, value, problems_of_value);
        try {
            problems_of_value.throw_if_any();
        } catch (const InputError& error) {
            problems.add("values", error.problems().front().code, "{}.keys: {}",
                         table, error.problems().front().what);
            continue;
        }
        problems.rule(
            ProblemCode::duplicate, {"key"},
            [&] { return !seen.insert(value.text).second; },
            "{}.keys has the value {} of {} twice (once is enough); remove one",
            table, value.text, factor.key);
    }
}

//! @param table name of the table of the study or search
//! @param problems problems of the factor
void check_key(const std::string& table, const KeyFactor& factor,
               const std::vector<VariableKey>& keys, const Spec& spec,
               const Problems& problems) {
    const auto variable =
        std::ranges::find(keys, factor.key, &VariableKey::name);
    const std::string reason =
        variable == keys.end()
            ? "(which is not a variable key of this campaign)"
            : fault(*variable);
    problems.rule(ProblemCode::unknown_name, {"key"}, !reason.empty(),
                  "{}.keys has \"{}\" {}; {}", table, factor.key, reason,
                  advice(factor.key, keys));
    if (!problems.usable({"key"})) return;
    if (factor.values.empty())
        check_range(table, factor, *variable, problems);
    else
        check_values(table, factor, spec, problems);
}

void check_keys(const std::string& table, const std::vector<KeyFactor>& factors,
                const Spec& spec, const Problems& problems) {
    if (factors.empty()) return;
    std::set<std::string> seen;
    Spec varied = spec;
    const std::vector<VariableKey> keys = variable_keys(varied);
    const auto varies = [&](const std::string& key) {
        return std::ranges::count(factors, key, &KeyFactor::key) > 0;
    };
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
        check_key(table, factor, keys, spec, of_factor);
        of_factor.rule(
            ProblemCode::contradiction, {"key"},
            factor.key == "spacing.density" && varies("spacing.plant"),
            "{}.keys has \"spacing.density\" and \"spacing.plant\" (each "
            "determines the other); remove one",
            table);
    }
}

//! Checks the keys of a draw, and its values together with the campaign.
void check_draw(const Spec& spec, const Draw& draw,
                const std::vector<VariableKey>& keys,
                const Problems& problems) {
    const std::size_t count = draw.keys.size();
    problems.rule(
        {"values", "keys"}, draw.values.size() != count,
        "draw.values has {} numbers (there are {} keys); give one for "
        "each key",
        draw.values.size(), count);
    bool is_valid = draw.values.size() == count;
    for (std::size_t i = 0; i < std::min(count, draw.values.size()); ++i) {
        const auto variable =
            std::ranges::find(keys, draw.keys[i], &VariableKey::name);
        std::string reason = "(which is not a variable key of this campaign)";
        if (variable != keys.end()) {
            reason = fault(*variable);
            if (reason.empty()) reason = fault_of_range(*variable);
        }
        problems.rule(ProblemCode::unknown_name, {"keys"}, !reason.empty(),
                      "draw.keys has \"{}\" {}; {}", draw.keys[i], reason,
                      advice(draw.keys[i], keys));
        is_valid &= reason.empty();
        if (!reason.empty()) continue;
        reason = fault_of(draw.values[i], variable->section, variable->key.key);
        problems.rule(
            {"values"}, [&] { return reason; }, ProblemCode::out_of_range);
        is_valid &= reason.empty();
    }
    if (!is_valid) return;
    Spec drawn = spec;
    set_keys(drawn, factors_of(draw), draw.values);
    const Problems of_stand(spec.name);
    check_variable(drawn, of_stand);
    try {
        of_stand.throw_if_any();
    } catch (const InputError& error) {
        problems.add("values", ProblemCode::contradiction,
                     "draw.values: with these values, {}",
                     error.problems().front().what);
    }
}

}  // namespace

void check_draws(const Spec& spec, const Problems& problems) {
    if (spec.draws.empty() || !spec.plant.crop.is_known || !problems.empty())
        return;
    Spec varied = spec;
    const std::vector<VariableKey> keys = variable_keys(varied);
    for (std::size_t i = 0; i < spec.draws.size(); ++i)
        check_draw(spec, spec.draws[i].value, keys, problems.in("draw", i));
}

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
    for (std::size_t i = 0; i < spec.sensitivity.keys.size(); ++i)
        problems.in("sensitivity")
            .in("keys", i)
            .rule(
                {"key"},
                spec.sensitivity.method == SensitivityMethod::morris &&
                    spec.sensitivity.keys[i].kind != GeneKind::real,
                "sensitivity.keys: {} has single values (Morris' method needs "
                "equal steps within a range of decimal numbers); use the "
                "method "
                "\"sobol\"",
                spec.sensitivity.keys[i].key);
    check_keys("search", spec.search.keys, spec, problems);
}

}  // namespace ideotype
