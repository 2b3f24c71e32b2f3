#include "checks.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "schema.hpp"

namespace ideotype {

namespace {

std::string lower_case(std::string text) {
    for (char& c : text)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

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

void check_search(const Campaign& campaign, Report& report) {
    const int& population = campaign.search.population;
    const auto at_most = [&](const std::string& name, const int& value,
                             int most) {
        if (report.usable({&population, &value}) && value > most)
            report.add(&value,
                       fmt::format("{} is {} (the population is {}); use {} "
                                   "or fewer",
                                   name, value, population, most));
    };
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
    if (campaign.first_tolerance > 0 &&
        report.usable({&campaign.first_tolerance}) &&
        !(light.tolerance > 0 && campaign.first_tolerance >= light.tolerance))
        report.add(&campaign.first_tolerance,
                   fmt::format("light.first_tolerance is {} (the tolerance "
                               "that it falls to is {}); give a tolerance "
                               "above 0 and at most that",
                               campaign.first_tolerance, light.tolerance));
}

void check_leaves(const Draft& draft, Report& report) {
    const StalkForm& stalk = draft.campaign.plant.stalk;
    const LeafEntry* below = nullptr;
    for (const LeafEntry& leaf : draft.leaves) {
        const LeafTraits& traits = leaf.traits;
        const double& height = leaf.form.insertion_height;
        if (report.usable({&traits.length, &traits.width}) &&
            traits.width > traits.length)
            report.add(&traits.width,
                       fmt::format("leaf.width is {} m (wider than its length "
                                   "of {} m); check the units: both are in m",
                                   traits.width, traits.length));
        if (report.usable({&height, &stalk.height}) && height > stalk.height)
            report.add(&height,
                       fmt::format("leaf.insertion_height is {} m (above the "
                                   "stalk's height of {} m); use {} m or less",
                                   height, stalk.height, stalk.height));
        if (below && report.usable({&height, &below->form.insertion_height}) &&
            height < below->form.insertion_height)
            report.add(&height,
                       fmt::format("leaf.insertion_height is {} m (below the "
                                   "leaf before it, at {} m); list the lowest "
                                   "leaf first",
                                   height, below->form.insertion_height));
        below = &leaf;
    }
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

void check_constraints(const Constraints& constraints, Report& report) {
    if (report.usable({&constraints.lai}) && constraints.lai.upper <= 0)
        report.add(&constraints.lai,
                   "constraints.lai allows no leaves (its upper bound is 0); "
                   "write [lower, upper]");
}

void check_blade(const BladeForm& blade, Report& report) {
    const std::vector<double>& controls = blade.width_controls;
    if (report.usable({&controls}) &&
        *std::max_element(controls.begin(), controls.end()) <= 0)
        report.add(&controls,
                   "blade.width_controls are all 0 (a blade has a width); "
                   "leave the key out for the usual profile");
}

//! Any trait set that breeds a trait, or nullptr.
const Named<TraitSet>* breeder(const Campaign& campaign,
                               bool TraitSet::*trait) {
    for (const Named<TraitSet>& set : campaign.trait_sets)
        if (set.value.*trait) return &set;
    return nullptr;
}

void check_baseline(const Draft& draft, Report& report) {
    const BoundsEntry& bounds = draft.bounds;
    const bool is_table = bounds.rule.empty();
    if (!is_table && !report.usable({&bounds.rule})) return;
    for (std::size_t i = 0; i < draft.leaves.size(); ++i) {
        const LeafTraits& traits = draft.leaves[i].traits;
        const LeafBounds allowed = leaf_bounds(bounds, traits);
        const auto check = [&](const std::string& name, const double& value,
                               const Range& range, const Range& written,
                               const std::string& unit, bool TraitSet::*trait) {
            const Named<TraitSet>* set = breeder(draft.campaign, trait);
            if (!set || !report.usable({&value})) return;
            if (is_table && !report.usable({&written})) return;
            if (value >= range.lower && value <= range.upper) return;
            report.add(
                &value,
                fmt::format("leaf.{} of leaf {} is {} {} (outside the {} "
                            "bounds {:.6g} .. {:.6g} {}, and trait set "
                            "\"{}\" breeds it); change the baseline, the "
                            "bounds or the free traits",
                            name, i + 1, value, unit,
                            is_table ? "table's" : '"' + bounds.rule + '"',
                            range.lower, range.upper, unit, set->name));
        };
        check("length", traits.length, allowed.length, bounds.table.length, "m",
              &TraitSet::length);
        check("width", traits.width, allowed.width, bounds.table.width, "m",
              &TraitSet::width);
        check("insertion_angle", traits.insertion_angle,
              allowed.insertion_angle, bounds.table.insertion_angle, "deg",
              &TraitSet::insertion_angle);
    }
}

}  // namespace

void check_draft(const Draft& draft, Report& report) {
    const Campaign& campaign = draft.campaign;
    check_names("site", campaign.sites, report);
    check_names("day", campaign.days, report);
    check_names("spacing", campaign.spacings, report);
    check_names("traits", campaign.trait_sets, report);
    // Repeated names of one axis have been told apart already.
    if (report.empty()) check_case_names(campaign, report);
    check_sky(campaign, report);
    for (const Named<Spacing>& spacing : campaign.spacings)
        check_spacing(spacing.value, report);
    check_surface("leaf", campaign.optics.leaf, report);
    check_surface("stalk", campaign.optics.stalk, report);
    check_field(campaign.field, report);
    check_light(campaign, report);
    check_constraints(campaign.constraints, report);
    check_search(campaign, report);
    check_plant(draft, report);
    check_baseline(draft, report);
}

void check_plant(const Draft& draft, Report& report) {
    check_blade(draft.campaign.plant.blade, report);
    check_leaves(draft, report);
}

}  // namespace ideotype
