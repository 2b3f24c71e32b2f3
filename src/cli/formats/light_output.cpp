// SPDX-License-Identifier: Apache-2.0
#include "light_output.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "ideotype/canopy/quantities.hpp"
#include "ideotype/core/clock.hpp"

namespace ideotype {

namespace {

Json in_unit(const Estimate& x, const std::string& unit) {
    Json json = to_json(x);
    json["unit"] = unit;
    return json;
}

//! Writes assimilation in its unit, which is that of a second for a single
//! light and that of a day for others.
Json assimilation_json(const Estimate& x, Span span) {
    return span == Span::single ? in_unit(scaled(x, 1e6), "umol m-2 s-1")
                                : in_unit(x, "mol m-2 day-1");
}

Estimate lowered(Estimate flux, double loss) {
    return {flux.mean - loss, flux.standard_error};
}

//! @param uptake flux that exceeds net assimilation by the loss
Json gross_and_net(const Estimate& gross, const Estimate& uptake, double loss,
                   Span span) {
    return {{"gross", assimilation_json(gross, span)},
            {"net", assimilation_json(lowered(uptake, loss), span)}};
}

bool has_stalks(const CanopyReport& report) {
    return !std::ranges::all_of(report.groups, &SurfaceId::is_leaf, &Group::id);
}

//! Returns the name of a group, with that of its component where there are
//! several.
std::string group_name(const CanopyReport& report, std::size_t group) {
    const Group& own = report.groups[group];
    return report.components.size() > 1 && !own.id.is_object()
               ? report.components[own.id.component].name + '_' + own.name
               : own.name;
}

//! Returns whether the sun shines in a step. Without it no leaf is sunlit.
bool has_sun(const StepReport& step) {
    return step.sunlit && step.budget.leaves_beam.mean > 0;
}

Json to_json(const BudgetEstimate& budget, const CanopyReport& report,
             const char* incident_unit) {
    const auto part = [&](Estimate x) {
        return to_json(fraction_of(x, budget.incident));
    };
    Json json{{"incident", budget.incident},
              {"incident_unit", incident_unit},
              {"unit", "fraction of incident"}};
    if (report.boundary == Boundary::isolated)
        json["entered"] = part(budget.entered);
    json["leaf"] = part(budget.leaves);
    if (has_stalks(report)) json["stalk"] = part(budget.organs);
    json["soil"] = part(budget.soil);
    json["reflected"] = part(budget.reflected);
    json["leaf_by_origin"] = {{"beam", part(budget.leaves_beam)},
                              {"sky", part(budget.leaves_sky)},
                              {"scattered", part(budget.leaves_scattered)}};
    return json;
}

//! Writes the leaf area in each class of absorbed light.
Json light_classes_json(const LightClassReport& classes) {
    Json json{{"ppfd_unit", "umol m-2 s-1"}, {"unit", "m2 m-2"}};
    for (std::size_t c = 0; c < ppfd_classes; ++c) {
        Json one{{"from", class_begin(c)}};
        if (c + 1 < ppfd_classes) one["to"] = class_begin(c + 1);
        one["sunlit"] = to_json(classes.sunlit[c]);
        one["shaded"] = to_json(classes.shaded[c]);
        json["classes"].push_back(std::move(one));
    }
    return json;
}

//! Returns quantities by name. For a single light they are fractions and areas
//! only, because it has no rates of a day.
Json quantities_json(const CanopyReport& report, Span span) {
    Json json = Json::object();
    for (const auto& [quantity, estimate] : measure_numbers(report)) {
        const std::string& unit = quantity.unit;
        if (span == Span::single && unit != "1" && unit != "m2 m-2") continue;
        json[quantity.name] = in_unit(estimate, unit);
    }
    return json;
}

Json assimilation_json(const CanopyReport& report, Span span) {
    const AssimilationReport& all = *report.assimilation;
    const CarbonLoss loss = sum_of(all.losses);
    const FluxReport& uptake = all.before_losses();
    Json json = gross_and_net(all.gross.sum, uptake.sum, loss.in_light, span);
    if (span == Span::day)
        json["carbon_balance"] =
            assimilation_json(lowered(uptake.sum, loss.all()), span);
    Json groups = Json::object();
    for (std::size_t g = 0; g < report.groups.size(); ++g)
        if (report.groups[g].id.is_leaf())
            groups.get_ref<Json::object_t&>().emplace_back(
                group_name(report, g),
                gross_and_net(all.gross.groups[g], uptake.groups[g],
                              all.losses[g].in_light, span));
    json["groups"] = std::move(groups);
    if (report.light_classes)
        json["leaf_area_by_absorbed_ppfd"] =
            light_classes_json(*report.light_classes);
    return json;
}

//! Returns the number that `take` finds in each band, as a fraction of the
//! light of the band.
template <class Take>
Json by_band(const CanopyReport& report, const Take& take) {
    Json json = Json::object();
    for (const BandReport& band : report.bands)
        json[band.name] =
            to_json(fraction_of(take(band), band.light.day.incident));
    return json;
}

Json components_json(const CanopyReport& report, Span span) {
    std::vector<ComponentAssimilation> assimilation;
    if (report.assimilation)
        assimilation = by_component(*report.assimilation, report.groups,
                                    report.components.size());
    Json json = Json::object();
    for (std::size_t c = 0; c < report.components.size(); ++c) {
        const ComponentReport& component = report.components[c];
        Json one = by_band(
            report, [&](const BandReport& band) { return band.part(c).all; });
        one["lai"] = component.lai;
        one["plant_area_index"] = component.plant_area_index;
        if (component.assimilates) {
            const ComponentAssimilation& all = assimilation[c];
            one["assimilation"] =
                gross_and_net(all.gross, all.uptake, all.loss.in_light, span);
        }
        json[component.name] = std::move(one);
    }
    return json;
}

//! Tells a component or a row of the field, by figures per area of its ground.
//! @param part place among the figures
//! @param net net assimilation; empty: leaves do not assimilate
Json part_json(double lai, const Randomised& light, std::size_t part,
               const std::vector<Randomised>& net) {
    Json json{{"lai", lai},
              {"absorbed_par", in_unit(light.estimate, "MJ m-2 day-1")}};
    if (!net.empty())
        json["net_assimilation"] =
            assimilation_json(net[part].estimate, Span::day);
    return json;
}

}  // namespace

Json to_json(const CanopyReport& report, Span span) {
    const DayReport& light = report.par().light;
    const auto part = [&](Estimate x) {
        return to_json(fraction_of(x, light.day.incident));
    };
    Json json{{"lai", report.lai}, {"ground_area_m2", report.ground_area}};
    json.update(
        to_json(light.day, report, span == Span::day ? "J m-2 day-1" : "1"));
    json["leaf_by_face"] = {{"upper", part(light.adaxial)},
                            {"lower", part(light.abaxial)}};
    json["leaf_by_layer"] = Json::array();
    for (std::size_t l = 0; l < light.layers.size(); ++l) {
        const double lower = report.layers.thickness * static_cast<double>(l);
        json["leaf_by_layer"].push_back(
            {{"from_m", lower},
             {"to_m", lower + report.layers.thickness},
             {"leaf", part(light.layers[l])}});
    }
    // All names differ, and looking each up among the others takes too long.
    Json groups = Json::object();
    for (std::size_t g = 0; g < report.groups.size(); ++g)
        groups.get_ref<Json::object_t&>().emplace_back(group_name(report, g),
                                                       part(light.groups[g]));
    json["groups"] = std::move(groups);
    if (report.boundary == Boundary::isolated)
        json["surface"] =
            "bounding box of the plot: light enters from all sides, so that "
            "fractions of what the ground area receives may exceed 1";
    json["balance_error"] = light.balance_error;
    if (span == Span::day) json["clock"] = clock_name(light.utc_offset);
    for (const StepReport& step : light.steps) {
        Json hour{{"hour", step.hour}};
        hour.update(to_json(step.budget, report, "W m-2"));
        if (has_sun(step)) hour["sunlit_leaf_area"] = to_json(*step.sunlit);
        if (span == Span::day)
            json["hours"].push_back(hour);
        else if (has_sun(step))
            json["sunlit_leaf_area"] = hour["sunlit_leaf_area"];
    }
    json["quantities"] = quantities_json(report, span);
    if (report.assimilation)
        json["assimilation"] = assimilation_json(report, span);
    return json;
}

Json scene_json(const CanopyReport& report, Span span) {
    Json json;
    json["bands"] = Json::array();
    for (const BandReport& band : report.bands)
        json["bands"].push_back(
            {{"name", band.name},
             {"incident", band.light.day.incident},
             {"incident_unit", span == Span::day ? "J m-2 day-1" : "1"},
             {"balance_error", band.light.balance_error}});
    json["unit"] = "fraction of incident";
    json["components"] = components_json(report, span);
    // All names differ, and looking each up among the others takes too long.
    Json groups = Json::object();
    for (std::size_t g = 0; g < report.groups.size(); ++g)
        groups.get_ref<Json::object_t&>().emplace_back(
            report.groups[g].name, by_band(report, [&](const BandReport& band) {
                return band.light.groups[g];
            }));
    json["groups"] = std::move(groups);
    json["soil"] = by_band(
        report, [](const BandReport& band) { return band.light.day.soil; });
    json["reflected"] = by_band(report, [](const BandReport& band) {
        return band.light.day.reflected;
    });
    json["lai"] = report.lai;
    json["ground_area_m2"] = report.ground_area;
    return json;
}

Json parts_json(const CanopyReport& report) {
    Json json = Json::object();
    const auto if_known = [&](const auto& measured, const char* quantity) {
        return report.assimilation ? measured(quantity, report)
                                   : std::vector<Randomised>{};
    };
    if (report.components.size() > 1) {
        const auto light = measure_parts("absorbed_par", report);
        const auto net = if_known(measure_parts, "net_assimilation");
        for (std::size_t i = 0; i < light.size(); ++i)
            json["components"][report.components[i].name] =
                part_json(report.components[i].lai, light[i], i, net);
    }
    if (report.rows.empty()) return json;
    const auto lai = measure_profile("lai_by_row", report);
    const auto light = measure_profile("absorbed_light_by_row", report);
    const auto net = if_known(measure_profile, "net_assimilation_by_row");
    for (std::size_t i = 0; i < report.rows.size(); ++i) {
        const RowReport& row = report.rows[i];
        Json one{{"component", report.components[row.component].name},
                 {"position_m", row.position},
                 {"width_m", row.width}};
        one.update(part_json(lai[i].estimate.mean,
                             light[i * report.bands.size()], i, net));
        json["rows"].push_back(std::move(one));
    }
    return json;
}

}  // namespace ideotype
