// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <set>

#include "checks.hpp"
#include "ideotype/canopy/quantities.hpp"

namespace ideotype {

namespace {

//! @param taken for each row of the field, whether a component occupies it
void check_rows(const ComponentSpec& component, std::vector<bool>& taken,
                const Problems& problems) {
    for (const double row : component.rows)
        problems.rule({"rows"}, [&]() -> std::string {
            const auto place = static_cast<std::size_t>(row) - 1;
            const bool is_row = row == std::floor(row) && place < taken.size();
            if (is_row && !taken[place]) {
                taken[place] = true;
                return "";
            }
            return fmt::format(
                "component.rows has {} ({}); use rows from 1 to {}, each for "
                "one component",
                row,
                is_row ? "which another component has"
                       : "which the field does not have",
                taken.size());
        });
}

//! Reports a component without a position, or with two kinds of positions.
void check_standing(const ComponentSpec& component, const Problems& problems) {
    const bool is_mixed = component.mixed > 0;
    // Do not use rule(): the position must be checked even if the component's
    // name is invalid.
    if (problems.usable({"rows", "mixed", "plants"}) &&
        component.rows.empty() != is_mixed)
        problems.add(
            "name", ProblemCode::contradiction,
            "component \"{}\" stands {}; give it either `rows` of the field or "
            "`mixed`, a number of plants among those of the main crop",
            component.name, is_mixed ? "in two ways" : "nowhere");
    problems.rule({"plants", "rows", "mixed"},
                  component.rows.empty() && is_mixed && component.plants > 0,
                  "component.plants is for components in rows; remove it, or "
                  "use `rows` instead of `mixed`");
}

//! Checks that components have different names and positions, and leave
//! positions for the main crop.
void check_places(const Spec& spec, const Problems& problems) {
    const FieldForm& field = spec.field;
    if (!problems.usable({"field.rows", "field.plants"})) return;
    std::set<std::string> names;
    if (spec.plant.crop.is_known)
        names.insert(lower_case(spec.plant.crop.baseline.name));
    std::vector<bool> taken(static_cast<std::size_t>(field.rows));
    std::ptrdiff_t mixed = 0;
    for (std::size_t i = 0; i < spec.components.size(); ++i) {
        const ComponentSpec& component = spec.components[i];
        const Problems of_component = problems.in("component", i);
        of_component.rule(
            ProblemCode::duplicate, {"name"},
            [&] { return !names.insert(lower_case(component.name)).second; },
            "component.name is \"{}\" (already used, perhaps for the main "
            "crop); give each a different name",
            component.name);
        check_rows(component, taken, of_component);
        check_standing(component, of_component);
        mixed += component.mixed;
        of_component.rule(
            {"name"}, std::ranges::count(taken, false) * field.plants <= mixed,
            "component \"{}\" leaves no position for plants of the main "
            "crop; the field has {} x {} positions",
            component.name, field.rows, field.plants);
        if (component.has_mesh()) continue;
        check_plant_optics(component.crop.optics, of_component);
        if (!component.crop.is_known) continue;
        check_photosynthesis(component.crop.photosynthesis,
                             component.crop.baseline.leaves.size(),
                             of_component);
        check_plant(component.crop, of_component.in("crop"));
    }
}

//! Reports row distances that do not form whole periods of the field.
//! @param problems problems of the field
void check_row_pattern(const FieldForm& field, const Problems& problems) {
    const auto count = static_cast<int>(field.row_pattern.size());
    problems.rule({"row_pattern", "rows"},
                  count > 0 && field.boundary == Boundary::isolated,
                  "field.row_pattern is for fields that repeat; remove it, or "
                  "set field.boundary = \"periodic\"");
    problems.rule({"row_pattern", "rows"}, count > 0 && field.rows % count != 0,
                  "field.row_pattern has {} distances, but the field has {} "
                  "rows; use a multiple of {} rows",
                  count, field.rows, count);
}

//! Reports a list unless it contains one number for each component.
//! @param problems problems of the objectives
void check_list(const std::vector<double>& list, const std::string& key,
                std::size_t components, const Problems& problems) {
    const bool is_given = !list.empty();
    problems.rule(
        {key}, is_given && components == 1,
        "objective.{} is given (it distinguishes components, but there is only "
        "the main crop); remove it, or add a [[component]]",
        key);
    problems.rule({key}, is_given && list.size() != components,
                  "objective.{} has {} numbers, but there are {} components "
                  "including the main crop; give one for each",
                  key, list.size(), components);
}

//! Reports weights and sole-crop yields that do not match the components, and
//! objectives that are not sums over components.
void check_weights(const Spec& spec, const Problems& root) {
    const ObjectiveSpec& objective = spec.objective;
    const Problems problems = root.in("objective");
    const std::size_t components = 1 + spec.components.size();
    const bool has_sole = !objective.sole.empty(),
               has_weights = !objective.weights.empty();
    check_list(objective.weights, "weights", components, problems);
    check_list(objective.sole, "sole", components, problems);
    check_list(objective.sole_errors, "sole_errors", components, problems);
    problems.rule({"sole_errors", "sole"},
                  !has_sole && !objective.sole_errors.empty(),
                  "objective.sole_errors is given (the standard errors of "
                  "objective.sole, which is missing); give both, or neither");
    problems.rule({"sole", "weights"}, has_sole && has_weights,
                  "objective.sole and objective.weights both weight the "
                  "components; remove one of them");
    problems.rule(
        {"sole", "maximise", "minimise"},
        has_sole &&
            objective.maximised.size() + objective.minimised.size() != 1,
        "objective.sole is given (each crop grown alone has one number there, "
        "for one objective); ask for one objective");
    problems.rule(
        {"weights"},
        has_weights && std::ranges::all_of(objective.weights,
                                           [](double x) { return x == 0; }),
        "objective.weights are all 0; give one that is not");
    const std::vector<std::string> sums = additive_objectives();
    const std::string list = has_sole ? "sole" : "weights";
    for (const auto& [key, name] : objective_keys(spec))
        root.rule(
            {"objective." + list, key},
            (has_sole || has_weights) && std::ranges::count(sums, name) == 0,
            "the objective {} is {}; remove objective.{}, or use one of {}",
            name,
            name.find('.') == std::string::npos
                ? "not a sum over components, which could be weighted"
                : "a quantity of one component",
            list, fmt::join(sums, ", "));
}

}  // namespace

void check_components(const Spec& spec, const Problems& problems) {
    check_places(spec, problems);
    check_component_meshes(spec, problems);
    check_row_pattern(spec.field, problems.in("field"));
    check_weights(spec, problems);
}

}  // namespace ideotype
