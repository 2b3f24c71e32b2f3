// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>

#include "checks.hpp"
#include "ideotype/canopy/quantities.hpp"

namespace ideotype {

namespace {

void check_name(const ComponentSpec& component,
                std::map<std::string, int>& names, const Problems& problems) {
    const std::string& name = component.name;
    if (problems.usable({"name"}) && ++names[lower_case(name)] > 1)
        problems.add("name",
                     "component.name is \"{}\" (already used, perhaps for the "
                     "plant that is bred); give each a name of its own",
                     name);
}

//! @param taken whether each row of the field has a component already
void check_rows(const ComponentSpec& component, std::vector<bool>& taken,
                const Problems& problems) {
    for (const double row : component.rows) {
        if (!problems.usable({"rows"})) return;
        const auto place = static_cast<std::size_t>(row) - 1;
        const bool is_row = row == std::floor(row) && place < taken.size();
        if (is_row && !taken[place])
            taken[place] = true;
        else
            problems.add("rows",
                         "component.rows has {} ({}); use rows from 1 to {}, "
                         "each for one component",
                         row,
                         is_row ? "which another component has"
                                : "which the field does not have",
                         taken.size());
    }
}

//! Reports a component that stands nowhere, or is placed in two ways.
void check_standing(const ComponentSpec& component, const Problems& problems) {
    if (!problems.usable({"rows", "mixed", "plants"})) return;
    const bool is_mixed = component.mixed > 0;
    if (component.rows.empty() != is_mixed)
        problems.add("name",
                     "component \"{}\" stands {}; give it either `rows` of the "
                     "field or `mixed`, a number of plants among those that "
                     "are bred",
                     component.name, is_mixed ? "in two ways" : "nowhere");
    else if (is_mixed && component.plants > 0)
        problems.add("plants",
                     "component.plants is for components in rows; remove it, "
                     "or use `rows` in the place of `mixed`");
}

//! Checks that components beside the crop have names and places of their own,
//! and leave places to the bred plants.
void check_places(const Spec& spec, const Problems& problems) {
    const FieldForm& field = spec.field;
    if (!problems.usable({"field.rows", "field.plants"})) return;
    std::map<std::string, int> names;
    if (spec.plant.crop.is_known)
        names[lower_case(spec.plant.crop.baseline.name)] = 1;
    std::vector<bool> taken(static_cast<std::size_t>(field.rows));
    std::ptrdiff_t mixed = 0;
    for (std::size_t i = 0; i < spec.components.size(); ++i) {
        const ComponentSpec& each = spec.components[i];
        const Problems own = problems.in("component", i);
        check_name(each, names, own);
        check_rows(each, taken, own);
        check_standing(each, own);
        mixed += each.mixed;
        if (std::ranges::count(taken, false) * field.plants <= mixed)
            own.add("name",
                    "component \"{}\" leaves no place to the plants that are "
                    "bred; the field has {} x {} places",
                    each.name, field.rows, field.plants);
        check_plant_optics(each.crop.optics, own);
        if (!each.crop.is_known) continue;
        check_photosynthesis(each.crop.photosynthesis,
                             each.crop.baseline.leaves.size(), own);
        check_plant(each.crop, own.in("crop"));
    }
}

//! Reports row distances that do not repeat in the field.
//! @param problems problems of the field
void check_row_pattern(const FieldForm& field, const Problems& problems) {
    const auto count = static_cast<int>(field.row_pattern.size());
    if (count == 0 || !problems.usable({"row_pattern", "rows"})) return;
    if (field.boundary == Boundary::isolated)
        problems.add("row_pattern",
                     "field.row_pattern is for fields that repeat; remove it, "
                     "or set field.boundary = \"periodic\"");
    else if (field.rows % count != 0)
        problems.add("row_pattern",
                     "field.row_pattern has {} distances, but the field has {} "
                     "rows; use a multiple of {} rows",
                     count, field.rows, count);
}

//! Reports a list that does not have a number for each component.
//! @param problems problems of the objectives
void check_list(const std::vector<double>& list, const std::string& key,
                std::size_t components, const Problems& problems) {
    if (list.empty()) return;
    if (components == 1)
        problems.add(
            key,
            "objective.{} is given (it tells components apart, and all plants "
            "are those that are bred); remove it, or add a [[component]]",
            key);
    else if (list.size() != components)
        problems.add(key,
                     "objective.{} has {} numbers, but there are {} components "
                     "with the plants that are bred; give one for each",
                     key, list.size(), components);
}

//! Reports keys for which an objective cannot be a land equivalent ratio.
void check_sole(const Spec& spec, std::size_t components,
                const Problems& problems) {
    const bool has_sole = !spec.objective.sole.empty();
    check_list(spec.objective.sole, "sole", components, problems);
    check_list(spec.objective.sole_errors, "sole_errors", components, problems);
    if (!has_sole && !spec.objective.sole_errors.empty())
        problems.add("sole_errors",
                     "objective.sole_errors is given (they are the errors of "
                     "objective.sole, which is not); give both, or neither");
    if (has_sole && !spec.objective.weights.empty())
        problems.add("sole",
                     "objective.sole and objective.weights both tell what "
                     "components count; remove one of them");
    if (has_sole &&
        spec.objective.maximised.size() + spec.objective.minimised.size() != 1)
        problems.add("sole",
                     "objective.sole is given (each crop grown alone has one "
                     "number there, for one objective); ask for one objective");
}

//! Reports weights that do not fit components, and objectives without parts.
void check_weights(const Spec& spec, const Problems& problems) {
    const std::vector<double>& weights = spec.objective.weights;
    const std::size_t components = 1 + spec.components.size();
    const Problems own = problems.in("objective");
    if (!own.usable({"weights", "sole", "sole_errors"})) return;
    check_list(weights, "weights", components, own);
    check_sole(spec, components, own);
    const bool has_sole = !spec.objective.sole.empty();
    if (!weights.empty() &&
        std::ranges::all_of(weights, [](double x) { return x == 0; }))
        own.add("weights", "objective.weights are all 0; give one that is not");
    const std::vector<std::string> sums = additive_objectives();
    for (const auto& [key, name] : objective_keys(spec, problems)) {
        if (!problems.usable(key)) continue;
        const std::string list = has_sole ? "sole" : "weights";
        if ((!weights.empty() || has_sole) &&
            std::ranges::count(sums, name) == 0)
            own.add(list,
                    "the objective {} is {}; remove objective.{}, or use one "
                    "of {}",
                    name,
                    name.find('.') == std::string::npos
                        ? "no sum over components, which could be weighted"
                        : "a quantity of one component",
                    list, fmt::join(sums, ", "));
    }
}

}  // namespace

void check_components(const Spec& spec, const Problems& problems) {
    check_places(spec, problems);
    check_row_pattern(spec.field, problems.in("field"));
    check_weights(spec, problems);
}

}  // namespace ideotype
