// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "checks.hpp"
#include "ideotype/canopy/quantities.hpp"

namespace ideotype {

namespace {

//! Tells a component that has the name of another one.
void check_name(const Draft& component, std::map<std::string, int>& names,
                Problems& problems) {
    const std::string& name = component.campaign.name;
    if (problems.usable({&name}) && ++names[lower_case(name)] > 1)
        problems.add(&name,
                     fmt::format("component.name is \"{}\" (already used, "
                                 "perhaps by the plant that is bred); give "
                                 "each a name of its own",
                                 name));
}

//! Tells rows that a component can't have.
//! @param taken whether each row of the field has a component
void check_rows(const Draft& component, std::vector<bool>& taken,
                Problems& problems) {
    for (const double row : component.rows) {
        if (!problems.usable({&component.rows})) return;
        const auto place = static_cast<std::size_t>(row) - 1;
        const bool is_row = row == std::floor(row) && place < taken.size();
        if (is_row && !taken[place])
            taken[place] = true;
        else
            problems.add(
                &component.rows,
                fmt::format("component.rows has {} ({}); the field has rows 1 "
                            "to {}, each for one component",
                            row,
                            is_row ? "which another has" : "which is no row",
                            taken.size()));
    }
}

//! Tells a component that stands nowhere, or in two ways.
void check_standing(const Draft& component, Problems& problems) {
    const int &mixed = component.standing.mixed,
              &plants = component.standing.plants;
    if (!problems.usable({&component.rows, &mixed, &plants})) return;
    const std::string& name = component.campaign.name;
    if (component.rows.empty() == (mixed == 0))
        problems.add(&name,
                     fmt::format("component \"{}\" stands {}; give it either "
                                 "`rows` of the field or `mixed`, a number of "
                                 "plants among those that are bred",
                                 name, mixed == 0 ? "nowhere" : "in two ways"));
    else if (mixed > 0 && plants > 0)
        problems.add(&plants,
                     "component.plants is for components in rows; remove it, "
                     "or use `rows` in the place of `mixed`");
}

//! Components beside the crop have names and places of their own, and leave
//! places to the plants that are bred.
void check_places(Draft& draft, Problems& problems) {
    const FieldForm& field = draft.campaign.field;
    if (!problems.usable({&field.rows, &field.plants})) return;
    std::map<std::string, int> names;
    if (draft.is_crop_known)
        names[lower_case(draft.campaign.crop.baseline.name)] = 1;
    std::vector<bool> taken(static_cast<std::size_t>(field.rows));
    std::ptrdiff_t mixed = 0;
    for (const std::shared_ptr<Draft>& each : draft.components) {
        check_name(*each, names, problems);
        check_rows(*each, taken, problems);
        check_standing(*each, problems);
        mixed += each->standing.mixed;
        const auto rows = std::count(taken.begin(), taken.end(), false);
        if (rows * field.plants <= mixed)
            problems.add(
                &each->campaign.name,
                fmt::format("component \"{}\" leaves no place to the "
                            "plants that are bred; the field has {} x "
                            "{} places",
                            each->campaign.name, field.rows, field.plants));
        const Campaign& own = each->campaign;
        check_surface("leaf", own.optics.leaf, problems);
        check_surface("stalk", own.optics.stalk, problems);
        check_surface("sheath", own.optics.sheath, problems);
        if (!each->is_crop_known) continue;
        check_photosynthesis(each->photosynthesis,
                             own.crop.baseline.leaves.size(), problems);
        check_plant(*each, problems);
    }
}

//! Tells row distances that do not repeat in the field.
void check_row_pattern(const FieldForm& field, Problems& problems) {
    const std::vector<double>& pattern = field.row_pattern;
    if (pattern.empty() || !problems.usable({&pattern, &field.rows})) return;
    const auto count = static_cast<int>(pattern.size());
    if (field.boundary == Boundary::isolated)
        problems.add(
            &pattern,
            "field.row_pattern is for fields that repeat; remove it, or "
            "set field.boundary = \"periodic\"");
    else if (field.rows % count != 0)
        problems.add(&pattern,
                     fmt::format("field.row_pattern has {} distances, but the "
                                 "field has {} rows; use a multiple of {} rows",
                                 count, field.rows, count));
}

//! Tells a list of numbers that does not have one for each component.
void check_list(const std::vector<double>& list, const std::string& key,
                std::size_t components, Problems& problems) {
    if (list.empty()) return;
    if (components == 1)
        problems.add(
            &list, fmt::format("objective.{} tell components apart, and there "
                               "is none but the plants that are bred; remove "
                               "them, or add a [[component]]",
                               key));
    else if (list.size() != components)
        problems.add(&list,
                     fmt::format("objective.{} has {} numbers, but there "
                                 "are {} components with the plants that are "
                                 "bred; give one for each",
                                 key, list.size(), components));
}

//! Tells what makes an objective no land equivalent ratio.
void check_sole(const Campaign& campaign, std::size_t components,
                Problems& problems) {
    const std::vector<double>&sole = campaign.sole,
          &errors = campaign.sole_errors;
    check_list(sole, "sole", components, problems);
    check_list(errors, "sole_errors", components, problems);
    if (sole.empty() && !errors.empty())
        problems.add(&errors,
                     "objective.sole_errors are those of objective.sole, which "
                     "is not given; give it, or remove them");
    if (sole.empty()) return;
    if (!campaign.weights.empty())
        problems.add(&sole,
                     "objective.sole and objective.weights both tell what "
                     "components count; remove one of them");
    if (campaign.maximised.size() + campaign.minimised.size() != 1)
        problems.add(&sole,
                     "objective.sole has what crops have of one quantity; ask "
                     "for one objective");
}

//! Tells weights that do not fit components, and objectives that have no parts.
void check_weights(const Draft& draft, Problems& problems) {
    const Campaign& campaign = draft.campaign;
    const std::vector<double>& weights = campaign.weights;
    const std::size_t components = 1 + draft.components.size();
    if (!problems.usable({&weights, &campaign.sole, &campaign.sole_errors}))
        return;
    const bool has_weights = !weights.empty();
    check_list(weights, "weights", components, problems);
    check_sole(campaign, components, problems);
    if (has_weights && std::all_of(weights.begin(), weights.end(),
                                   [](double x) { return x == 0; }))
        problems.add(&weights,
                     "objective.weights are all 0; give one that is not");
    const std::vector<std::string> sums = additive_objectives();
    for (const auto* list : {&campaign.maximised, &campaign.minimised})
        for (const std::string& each : *list) {
            if (!problems.usable({list})) break;
            if (is_of_two_components(each) && components != 2)
                problems.add(list,
                             fmt::format("the objective {} compares two "
                                         "components, and there are {}; add or "
                                         "remove a [[component]]",
                                         each, components));
            const bool has_sole = !campaign.sole.empty();
            if ((has_weights || has_sole) &&
                std::find(sums.begin(), sums.end(), each) == sums.end())
                problems.add(has_sole ? &campaign.sole : &weights,
                             fmt::format("the objective {} is {}; remove "
                                         "objective.{}, or use one of {}",
                                         each,
                                         each.find('.') == std::string::npos
                                             ? "no sum over components"
                                             : "that of one component",
                                         has_sole ? "sole" : "weights",
                                         fmt::join(sums, ", ")));
        }
}

}  // namespace

void check_components(Draft& draft, Problems& problems) {
    check_places(draft, problems);
    check_row_pattern(draft.campaign.field, problems);
    check_weights(draft, problems);
}

}  // namespace ideotype
