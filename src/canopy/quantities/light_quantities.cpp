// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "declaration.hpp"
#include "ideotype/core/units.hpp"
#include "randomised.hpp"

namespace ideotype {

namespace {

using Values = std::vector<Estimate>;

Values to_mj(Values joules) {
    for (Estimate& x : joules) x = scaled(x, 1 / joule_per_megajoule);
    return joules;
}

//! Returns a part of the light budget of a mean day.
Randomised part_of_light(const CanopyReport& report,
                         Estimate BudgetEstimate::*part,
                         double (*of)(const Budget&)) {
    return {report.par().light.day.*part,
            mapped(report.par().budget_by_randomisation, of)};
}

Randomised absorbed_by_leaves(const CanopyReport& report) {
    return part_of_light(report, &BudgetEstimate::leaves,
                         [](const Budget& day) { return day.leaves; });
}

//! Extracts a part of the light budget as a fraction of incident light; 0
//! without light.
TakeNumber fraction(Estimate BudgetEstimate::*part,
                    double (*of)(const Budget&)) {
    return [=](const CanopyReport& report) {
        return fraction_of(part_of_light(report, part, of),
                           report.par().light.day.incident);
    };
}

TakeNumber fapar() {
    return fraction(&BudgetEstimate::plants,
                    [](const Budget& day) { return day.leaves + day.organs; });
}

//! Returns -ln(1 - fAPAR) / LAI with errors to first order. 1 - fAPAR is set to
//! at least its standard error. The coefficient is undefined for an isolated
//! plot because light enters through its sides.
std::optional<Randomised> extinction_coefficient(const CanopyReport& report) {
    if (report.boundary == Boundary::isolated) return std::nullopt;
    const Randomised absorbed = *fapar()(report);
    const double mean = absorbed.estimate.mean,
                 error = absorbed.estimate.standard_error;
    constexpr double least = 1e-9;
    const double left = std::max({1 - mean, error, least});
    const double depth = -std::log(left);
    return per_leaf_area(
        report, {{depth, error / left},
                 mapped(absorbed.by_randomisation,
                        [&](double x) { return depth + (x - mean) / left; })});
}

//! Returns the light absorbed by the leaves of each component, followed by the
//! light absorbed by each of its other organs.
Values by_organ(const CanopyReport& report) {
    const BandReport& par = report.par();
    Values organs;
    for (std::uint32_t c = 0; c < report.components.size(); ++c) {
        organs.push_back(par.part(c).leaves);
        for (std::size_t g = 0; g < report.groups.size(); ++g)
            if (const SurfaceId& id = report.groups[g].id;
                id.component == c && !id.is_leaf())
                organs.push_back(par.light.groups[g]);
    }
    return organs;
}

Values by_hour(const CanopyReport& report) {
    return mapped(report.par().light.steps,
                  [](const StepReport& step) { return step.budget.leaves; });
}

}  // namespace

std::vector<Declaration> light_quantities() {
    using Report = CanopyReport;
    return {
        {{"absorbed_par", daily, "PAR that leaves absorb per ground area"},
         MeanOver::nothing,
         [](const Report& r) {
             return scaled(absorbed_by_leaves(r), 1 / joule_per_megajoule);
         }},
        {{"absorbed_par_per_leaf_area", daily,
          "PAR that leaves absorb per one-sided leaf area"},
         MeanOver::leaf_area,
         [](const Report& r) {
             return per_leaf_area(
                 r, scaled(absorbed_by_leaves(r), 1 / joule_per_megajoule));
         }},
        {exact({"incident", daily, "PAR on level ground above the canopy"}),
         MeanOver::nothing,
         [](const Report& r) {
             return scaled(certain(r, r.par().light.day.incident),
                           1 / joule_per_megajoule);
         }},
        {{"absorbed_fraction", "1", "PAR that leaves absorb over incident PAR"},
         MeanOver::incident_light,
         fraction(&BudgetEstimate::leaves,
                  [](const Budget& day) { return day.leaves; })},
        {{"stalk_fraction", "1",
          "PAR that stalks, sheaths and other organs absorb over incident PAR"},
         MeanOver::incident_light,
         fraction(&BudgetEstimate::organs,
                  [](const Budget& day) { return day.organs; })},
        {{"fapar", "1",
          "PAR that leaves and other organs absorb over incident PAR"},
         MeanOver::incident_light,
         fapar()},
        {{extinction, "1",
          "extinction coefficient of the day's light: -ln(1 - fapar) / lai"},
         MeanOver::leaf_area_time,
         extinction_coefficient},
        {{"soil_fraction", "1", "PAR that the soil absorbs over incident PAR"},
         MeanOver::incident_light,
         fraction(&BudgetEstimate::soil,
                  [](const Budget& day) { return day.soil; })},
        {{"reflected_fraction", "1",
          "PAR that escapes to the sky over incident PAR"},
         MeanOver::incident_light,
         fraction(&BudgetEstimate::reflected,
                  [](const Budget& day) { return day.reflected; })},
        {exact({"balance_error", "1",
                "largest error of the energy balance of any randomisation over "
                "the light that entered"}),
         MeanOver::incident_light,
         [](const Report& r) {
             return certain(r, r.par().light.balance_error);
         },
         {},
         true},
        {exact({"paths", "1", "paths of light in all randomisations"}),
         MeanOver::nothing,
         [](const Report& r) {
             return certain(r, static_cast<double>(r.paths));
         },
         {},
         true},
        {exact({"capped", "1", "1 if the tolerance would need more paths"}),
         MeanOver::incident_light,
         [](const Report& r) { return certain(r, r.is_capped ? 1.0 : 0.0); },
         {},
         true},
        {exact({"lai", "m2 m-2", "one-sided leaf area per ground area"}),
         MeanOver::time, [](const Report& r) { return certain(r, r.lai); }},
        {exact({"plant_area_index", "m2 m-2",
                "leaf area and half the surface of all other organs per ground "
                "area"}),
         MeanOver::time,
         [](const Report& r) { return certain(r, r.plant_area_index); }},
        {exact({"dead_area_index", "m2 m-2",
                "area of dead parts of leaves per ground area"}),
         MeanOver::time,
         [](const Report& r) { return certain(r, r.dead_area_index); },
         [](const Scope& scope) { return scope.grows; }},
        {by({"leaf"},
            {"absorbed_by_leaf", daily, "PAR that each leaf absorbs"}),
         MeanOver::nothing,
         [](const Report& r) {
             return of_leaves(r, randomised(r.par().light.groups,
                                            r.par().groups_by_randomisation,
                                            1 / joule_per_megajoule));
         }},
        {by({"organ"}, {"absorbed_by_organ", daily,
                        "PAR that leaves and each other organ absorb"}),
         MeanOver::nothing, [](const Report& r) { return to_mj(by_organ(r)); }},
        {by({"layer"}, {"absorbed_by_layer", daily,
                        "PAR that leaves in each layer absorb"}),
         MeanOver::nothing,
         [](const Report& r) {
             return randomised(r.par().light.layers,
                               r.par().layers_by_randomisation,
                               1 / joule_per_megajoule);
         }},
        {by({"light_source"},
            {"absorbed_by_source", daily,
             "PAR that leaves absorb, by where it came from last"}),
         MeanOver::nothing,
         [](const Report& r) {
             const BudgetEstimate& day = r.par().light.day;
             return to_mj(
                 {day.leaves_beam, day.leaves_sky, day.leaves_scattered});
         }},
        {by({"leaf_side"}, {"absorbed_by_side", daily,
                            "PAR that each side of leaves absorbs"}),
         MeanOver::nothing,
         [](const Report& r) {
             return to_mj({r.par().light.adaxial, r.par().light.abaxial});
         }},
        {by({"hour"}, {"absorbed_by_hour", "W m-2",
                       "PAR that leaves absorb at each instant"}),
         MeanOver::time, by_hour},
        {by({"day"},
            {"absorbed_by_day", daily, "PAR that leaves absorb on each day"}),
         MeanOver::nothing,
         [](const Report& r) { return to_mj(r.par().light.dates); }},
    };
}

std::vector<Declaration> form_quantities() {
    using Report = CanopyReport;
    return {{exact({"plant_height", "m",
                    "height of the highest point of the full-grown plant"}),
             MeanOver::time,
             [](const Report& r) { return certain(r, r.form->height); }},
            {exact({"top_leaf_angle", "deg",
                    "mean insertion angle of the four highest leaves from the "
                    "stalk"}),
             MeanOver::time, [](const Report& r) {
                 return certain(r, r.form->top_leaf_angle);
             }}};
}

std::vector<Declaration> line_quantities() {
    using Report = CanopyReport;
    return {{exact({"distance_from_lines", "1",
                    "Mahalanobis distance of the plant from the mean of "
                    "measured lines"}),
             MeanOver::incident_light,
             [](const Report& r) { return certain(r, r.lines->from_mean); }},
            {exact({"distance_from_line", "1",
                    "Mahalanobis distance of the plant from the nearest "
                    "measured line"}),
             MeanOver::incident_light,
             [](const Report& r) { return certain(r, r.lines->from_line); }},
            {exact({"nearest_line", "1",
                    "number of the nearest measured line, 1 is the first of "
                    "the file; 0: no lines are told"}),
             MeanOver::incident_light,
             [](const Report& r) {
                 return certain(r, static_cast<double>(r.lines->line));
             },
             {},
             true,
             [](const Details& details) {
                 return mapped(details.lines->lines, &MeasuredLine::name);
             }}};
}

}  // namespace ideotype
