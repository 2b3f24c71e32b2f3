// SPDX-License-Identifier: Apache-2.0
#include "checks.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "ideotype/canopy/quantities.hpp"
#include "key_factors.hpp"
#include "schema.hpp"

namespace ideotype {

std::string lower_case(std::string text) {
    for (char& c : text)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

void check_surface(const std::string& name, const Lambertian& surface,
                   Report& report) {
    if (!report.usable({&surface.reflectance, &surface.transmittance})) return;
    // Decimal fractions such as 0.7 + 0.3 may exceed 1 by rounding.
    if (surface.reflectance + surface.transmittance <= 1 + 1e-12) return;
    report.add(&surface.transmittance,
               fmt::format("optics.{}_transmittance is {} (more than all "
                           "light with a reflectance of {}); use {:.6g} or "
                           "less",
                           name, surface.transmittance, surface.reflectance,
                           1 - surface.reflectance));
}

namespace {

template <class Entry>
void check_names(const std::string& axis, const std::vector<Entry>& entries,
                 Report& report) {
    // Names of cases are lower case: they are names of files.
    std::map<std::string, const std::string*> first;
    for (const Entry& entry : entries) {
        const std::string* name = &entry.name;
        if (!report.usable({name})) continue;
        const auto [earlier, is_new] = first.emplace(lower_case(*name), name);
        if (!is_new)
            report.add(
                name,
                fmt::format("{}.name is \"{}\" (already used in line "
                            "{}); give each a name of its own",
                            axis, *name, report.where(earlier->second).line));
    }
}

//! Many cases are work for months, and too many to look at in time. Returns
//! whether there are few enough.
bool check_count(const Campaign& campaign, Report& report) {
    double count = campaign.replicates;
    const auto multiply = [&](const std::string& axis, std::size_t entries) {
        if (!is_over(campaign, axis)) count *= static_cast<double>(entries);
    };
    multiply("site", campaign.sites.size());
    multiply("day", campaign.days.size() + campaign.climates.size());
    multiply("spacing", campaign.spacings.size());
    multiply("traits", campaign.trait_sets.size());
    if (count <= static_cast<double>(most_cases)) return true;
    report.add(&campaign.replicates,
               fmt::format("there are {:.0f} cases (sites x days x spacings "
                           "x trait sets x replicates; the limit is {}); "
                           "split the campaign",
                           count, most_cases));
    return false;
}

//! Names may contain the underscore that joins them to the name of a case.
void check_case_names(const Campaign& campaign, Report& report) {
    std::map<std::string, const Case> first;
    for (const Case& chosen : cases(campaign)) {
        const auto [earlier, is_new] = first.emplace(chosen.name, chosen);
        if (is_new) continue;
        const auto named = std::find_if(
            campaign.sites.begin(), campaign.sites.end(),
            [&](const Site& site) { return site.name == chosen.site.name; });
        if (report.usable({&named->name}))
            report.add(&named->name,
                       fmt::format("site.name is \"{}\" (with the names of "
                                   "the other axes two cases are called {}); "
                                   "rename one of the entries",
                                   named->name, chosen.name));
        return;
    }
}

void check_spacing(const Spacing& spacing, Report& report) {
    // Wider than crops stand, and too wide for plants to meet.
    constexpr double usual = 2;
    const auto check = [&](const std::string& name, const double& value) {
        if (report.usable({&value}) && value > usual)
            report.warn(
                &value,
                fmt::format("spacing.{} is {} m (crops stand closer; {} inches "
                            "are {:.4g} m, {} feet {:.4g} m); give metres",
                            name, value, value, value * 0.0254, value,
                            value * 0.3048));
    };
    check("row", spacing.row);
    check("plant", spacing.plant);
    if (report.usable({&spacing.row, &spacing.plant, &spacing.density}) &&
        !(spacing.plant > 0))
        report.add(&spacing.row,
                   "missing key 'plant' in [[spacing]], the distance [m] "
                   "between neighbours in a row; or 'density', the number of "
                   "plants per square metre");
}

//! Warns of stands that hold more leaves of the baseline than fields have.
void check_leaf_area(const Campaign& campaign, Report& report) {
    const double area =
        plant_area(build_plant(campaign.crop.baseline, campaign.tessellation))
            .leaves;
    for (const auto& [name, spacing] : campaign.spacings)
        if (const std::string doubt =
                doubt_of_lai(area / (spacing.row * spacing.plant));
            !doubt.empty())
            report.warn(&spacing.row,
                        fmt::format("spacing.row is {} m (with {} m between "
                                    "plants the baseline {}); check both "
                                    "distances",
                                    spacing.row, spacing.plant, doubt));
}

void check_objectives(const Campaign& campaign, bool is_study, Report& report) {
    if (!report.usable({&campaign.maximised, &campaign.minimised})) return;
    const std::size_t count = aims(campaign).size();
    for (const std::string& each : campaign.minimised)
        if (std::count(campaign.maximised.begin(), campaign.maximised.end(),
                       each) > 0)
            report.add(&campaign.minimised,
                       fmt::format("objective.minimise has {} (which is "
                                   "maximised too); remove one of the two",
                                   each));
    if (campaign.field.boundary == Boundary::isolated)
        for (const auto* list : {&campaign.maximised, &campaign.minimised})
            if (std::count(list->begin(), list->end(), extinction) > 0)
                report.add(list,
                           fmt::format("the objective {} needs plants without "
                                       "end (light enters a plot from its "
                                       "sides); use \"fapar\"",
                                       extinction));
    const std::vector<double>& reference = campaign.search.reference;
    if (!reference.empty() && reference.size() != count &&
        report.usable({&reference}))
        report.add(&reference,
                   fmt::format("search.reference has {} numbers (there are {} "
                               "objectives); give one for each, those that are "
                               "maximised first",
                               reference.size(), count));
    const bool is_pareto = campaign.search.optimizer == OptimizerKind::nsga2;
    if (count == 0)
        report.add(&campaign.maximised,
                   "objective.maximise is empty (nothing would be searched "
                   "for); name a quantity");
    else if (is_pareto && count == 1)
        report.add(&campaign.search.optimizer,
                   "search.optimizer is \"nsga2\" (which finds a front of "
                   "several objectives); name another in objective.minimise, "
                   "or use \"cma_es\"");
    else if (!is_pareto && count > 1 && !is_study)
        report.add(&campaign.minimised,
                   fmt::format("there are {} objectives (only nsga2 finds a "
                               "front of several); use one, or "
                               "search.optimizer = \"nsga2\"",
                               count));
}

void check_scenarios(const Campaign& campaign, Report& report) {
    if (!report.usable({&campaign.over})) return;
    const bool has_days = campaign.climates.empty();
    const std::string wrong = has_days ? "climate" : "day";
    if (is_over(campaign, wrong))
        report.add(&campaign.over,
                   fmt::format("objective.over has \"{}\" (this campaign has "
                               "[[{}]]); use that, or remove it",
                               wrong, has_days ? "day" : "climate"));
}

//! Reports what only campaigns with a near infrared band can have.
void check_bands(const Campaign& campaign, Report& report) {
    if (campaign.has_nir) return;
    const std::string add = "add [[band]] with name = \"nir\"";
    if (campaign.bounded_band == BoundedBand::nir)
        report.add(
            &campaign.bounded_band,
            "light.band is \"nir\" (light is followed in PAR alone); " + add);
    for (const Aim& aim : aims(campaign)) {
        const auto* list = aim.sense == Sense::maximise ? &campaign.maximised
                                                        : &campaign.minimised;
        if (report.usable({list}) && is_of_nir(aim.quantity))
            report.add(list,
                       fmt::format("the objective {} needs near infrared; {}",
                                   aim.name, add));
    }
}

void check_stop(const StopRules& stop, Report& report) {
    constexpr int fewest = 5;
    if (stop.no_gain > 0 && stop.no_gain < fewest)
        report.add(&stop.no_gain,
                   fmt::format("stop.no_gain is {} (too few generations for "
                               "the error of a slope); use {} or more, or 0",
                               stop.no_gain, fewest));
}

void check_search(const Campaign& campaign, bool is_study, Report& report) {
    const int& population = campaign.search.population;
    const auto at_most = [&](const std::string& name, const int& value,
                             int most) {
        if (report.usable({&population, &value}) && value > most)
            report.add(&value,
                       fmt::format("{} is {} (the population is {}); use {} "
                                   "or fewer",
                                   name, value, population, most));
    };
    check_objectives(campaign, is_study, report);
    check_stop(campaign.stop, report);
    check_scenarios(campaign, report);
    // Each search by CMA-ES ranks four plants or more.
    const int fewest =
        campaign.search.optimizer == OptimizerKind::automatic ? 8 : 4;
    if (uses_cma_es(campaign.search) && report.usable({&population}) &&
        population < fewest)
        report.add(&population,
                   fmt::format("search.population is {} (CMA-ES ranks at least "
                               "{} plants); use {} or more, or leave it out",
                               population, fewest, fewest));
    constexpr double most_rows = std::numeric_limits<std::int32_t>::max();
    const int& generations = campaign.stop.generations;
    if (report.usable({&population, &generations}) &&
        1. * population * generations > most_rows)
        report.add(
            &generations,
            fmt::format("stop.generations is {} (with a population of "
                        "{} a history would have more rows than {:.0f}); "
                        "use {:.0f} or fewer",
                        generations, population, most_rows,
                        std::floor(most_rows / population)));
    at_most("search.elites", campaign.search.ga.elites, population - 1);
    at_most("search.tournament", campaign.search.ga.tournament, population);
    at_most("final.candidates", campaign.final_rule.candidates, population);
}

void check_light(const Campaign& campaign, Report& report) {
    const Accuracy& light = campaign.sampling;
    if (!report.usable({&light.tolerance})) return;
    constexpr int fewest = 8;
    if (light.tolerance > 0 && report.usable({&light.randomisations}) &&
        light.randomisations < fewest)
        report.add(&light.randomisations,
                   fmt::format("light.randomisations is {} (too few to tell "
                               "whether a tolerance is met); use {} or more",
                               light.randomisations, fewest));
    constexpr int fewest_fields = 4;
    if (!report.usable({&light.fields, &light.randomisations}) ||
        light.fields == 1)
        return;
    if (light.fields < fewest_fields)
        report.add(&light.fields,
                   fmt::format("light.fields is {} (too few to tell how fields "
                               "differ); use 1, or {} or more",
                               light.fields, fewest_fields));
    else if (light.randomisations % light.fields != 0)
        report.add(&light.fields,
                   fmt::format("light.fields is {}, among which {} "
                               "randomisations can't be divided evenly",
                               light.fields, light.randomisations));
}

//! Faces of the leaves of a field must have room in the memory.
void check_faces(const Campaign& campaign, Report& report) {
    constexpr double most = 20e6;
    const FieldForm& field = campaign.field;
    const int& cells = campaign.tessellation.cells_along;
    if (!report.usable({&field.rows, &field.plants, &cells})) return;
    const auto leaves =
        static_cast<double>(campaign.crop.baseline.leaves.size());
    const double faces = 2. * cells * leaves * field.rows * field.plants;
    if (faces > most)
        report.add(&cells,
                   fmt::format("plant.cells_along is {} (the leaves of {} x {} "
                               "plants have {:.0f} faces, the limit is {:.0f});"
                               " use fewer, or a smaller field",
                               cells, field.rows, field.plants, faces, most));
}

void check_field(const FieldForm& field, Report& report) {
    if (!report.usable({&field.rows, &field.plants, &field.border_rows}))
        return;
    if (field.border_rows == 0) return;
    if (field.boundary == Boundary::periodic)
        report.add(
            &field.border_rows,
            "field.border_rows is not 0 (a field that repeats without end has "
            "no edges); add boundary = \"isolated\" or leave it out");
    else if (2 * field.border_rows >= std::min(field.rows, field.plants))
        report.add(
            &field.border_rows,
            fmt::format("field.border_rows is {} (nothing is left of {} x {} "
                        "plants); use {} or less",
                        field.border_rows, field.rows, field.plants,
                        (std::min(field.rows, field.plants) - 1) / 2));
}

}  // namespace

std::string doubt_of_lai(double lai) {
    constexpr double most = 8;
    return lai > most ? fmt::format(
                            "has a leaf area index of {:.2f}, and "
                            "fields hardly ever have more than {}",
                            lai, most)
                      : "";
}

void check_draft(Draft& draft, Report& report) {
    const Campaign& campaign = draft.campaign;
    check_names("site", campaign.sites, report);
    check_names("day", campaign.days, report);
    check_names("climate", campaign.climates, report);
    check_names("spacing", campaign.spacings, report);
    check_names("traits", campaign.trait_sets, report);
    const bool are_few = check_count(campaign, report);
    // Repeated names of one axis have been told apart already.
    if (report.empty()) check_case_names(campaign, report);
    if (are_few) check_sky(campaign, report);
    for (const Named<Spacing>& spacing : campaign.spacings)
        check_spacing(spacing.value, report);
    check_surface("leaf", campaign.optics.leaf, report);
    check_surface("stalk", campaign.optics.stalk, report);
    check_surface("sheath", campaign.optics.sheath, report);
    for (const auto& [name, surface] :
         {std::pair("nir.leaf", &campaign.nir_optics.leaf),
          std::pair("nir.stalk", &campaign.nir_optics.stalk),
          std::pair("nir.sheath", &campaign.nir_optics.sheath)})
        check_surface(name, *surface, report);
    check_names("band", campaign.bands, report);
    check_bands(campaign, report);
    check_components(draft, report);
    check_growing(draft, report);
    check_objects(draft, report);
    check_field(campaign.field, report);
    if (draft.is_crop_known) check_faces(campaign, report);
    check_light(campaign, report);
    check_search(campaign, draft.is_study, report);
    check_sensitivity(draft, report);
    check_photosynthesis(
        draft.photosynthesis,
        draft.is_crop_known ? campaign.crop.baseline.leaves.size() : 0, report);
    check_plant(draft, report);
    check_breeding(draft, report);
    check_feasibility(draft, report);
    if (draft.is_crop_known && report.empty())
        check_leaf_area(campaign, report);
}

}  // namespace ideotype
