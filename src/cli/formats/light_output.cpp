// SPDX-License-Identifier: Apache-2.0
#include "light_output.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "ideotype/core/clock.hpp"

namespace ideotype {

namespace {

Json in_unit(const Estimate& x, const std::string& unit) {
    Json json = to_json(x);
    json["unit"] = unit;
    return json;
}

//! Makes an object with one member for each name. The values are computed from
//! the indices of the names.
template <class Value>
Json named(const std::vector<std::string>& names, const Value& value) {
    Json json = Json::object();
    // Append members without the linear look-up of operator[], since names are
    // unique.
    for (std::size_t i = 0; i < names.size(); ++i)
        json.get_ref<Json::object_t&>().emplace_back(names[i], value(i));
    return json;
}

//! Adds results as fractions of the incident light.
//! @param incident incident light, in total or by waveband
void add(const std::vector<LightResult>& results,
         const std::vector<double>& incident, const CanopyReport& report,
         Json& json) {
    const double thickness = report.layers.thickness;
    for (const LightResult& result : results) {
        const auto part = [&](std::size_t i, std::size_t band = 0) {
            return to_json(fraction_of(result.values[i], incident[band]));
        };
        const std::vector<ResultAxis>& along = result.along;
        if (!result.has_surfaces) continue;
        Json& entry = json[result.key];
        if (along.empty()) {
            entry = part(0);
        } else if (along.size() == 2) {
            const std::size_t count = along[1].labels.size();
            entry = named(along[1].labels, [&](std::size_t i) {
                return named(along[0].labels, [&](std::size_t band) {
                    return part(band * count + i, band);
                });
            });
        } else if (!along[0].labels.empty()) {
            entry = named(along[0].labels, [&](std::size_t i) {
                return part(i, incident.size() > 1 ? i : 0);
            });
        } else {
            entry = Json::array();
            for (std::size_t l = 0; l < result.values.size(); ++l) {
                const double lower = thickness * static_cast<double>(l);
                entry.push_back({{"from_m", lower},
                                 {"to_m", lower + thickness},
                                 {"leaf", part(l)}});
            }
        }
    }
}

//! Returns whether direct sunlight reaches leaves during a step.
bool has_sun(const StepReport& step) {
    return step.sunlit && step.budget.leaves_beam.mean > 0;
}

Json to_json(const BudgetEstimate& budget, const CanopyReport& report,
             const char* incident_unit) {
    Json json{{"incident", budget.incident},
              {"incident_unit", incident_unit},
              {"unit", "fraction of incident"}};
    add(budget_results(budget, report), {budget.incident}, report, json);
    return json;
}

//! Returns the leaf area in each class of absorbed light.
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

//! Returns the assimilation of one part of a canopy.
Json carbon_json(const std::vector<LightResult>& results, std::size_t part,
                 Span span) {
    Json json;
    for (const LightResult& each : results)
        json[each.key] = in_unit(each.values[part], carbon_unit(span));
    return json;
}

Json assimilation_json(const CanopyReport& report, Span span) {
    Json json =
        carbon_json(carbon_results(report, CarbonOf::all, span), 0, span);
    const auto groups = carbon_results(report, CarbonOf::groups, span);
    json["groups"] = Json::object();
    for (std::size_t g = 0; g < report.groups.size(); ++g)
        if (report.groups[g].id.is_leaf())
            json["groups"].get_ref<Json::object_t&>().emplace_back(
                groups.front().along.front().labels[g],
                carbon_json(groups, g, span));
    if (report.light_classes)
        json["leaf_area_by_absorbed_ppfd"] =
            light_classes_json(*report.light_classes);
    return json;
}

//! Returns quantities of a component or of a row of the field, per ground area
//! of this part.
//! @param part index of the component or row
//! @param net net assimilation; empty if it is not computed
Json part_json(double lai, const Randomised& light, std::size_t part,
               const std::vector<Randomised>& net) {
    Json json{{"lai", lai},
              {"absorbed_par", in_unit(light.estimate, "MJ m-2 day-1")}};
    if (!net.empty())
        json["net_assimilation"] =
            in_unit(net[part].estimate, carbon_unit(Span::day));
    return json;
}

}  // namespace

Json to_json(const CanopyReport& report, Span span) {
    const DayReport& light = report.par().light;
    Json json{{"lai", report.lai}, {"ground_area_m2", report.ground_area}};
    json.update(
        to_json(light.day, report, span == Span::day ? "J m-2 day-1" : "1"));
    add(part_results(report), {light.day.incident}, report, json);
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
    json["quantities"] = Json::object();
    for (const auto& [quantity, estimate] : numbers_of(report, span))
        json["quantities"][quantity.name] = in_unit(estimate, quantity.unit);
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
    std::vector<double> incident;
    for (const BandReport& band : report.bands)
        incident.push_back(band.light.day.incident);
    add(band_results(report), incident, report, json);
    std::vector<LightResult> carbon;
    if (report.assimilation)
        carbon = carbon_results(report, CarbonOf::components, span);
    for (std::size_t c = 0; c < report.components.size(); ++c) {
        const ComponentReport& component = report.components[c];
        Json& one = json["components"][component.name];
        one["lai"] = component.lai;
        one["plant_area_index"] = component.plant_area_index;
        if (component.assimilates)
            one["assimilation"] = carbon_json(carbon, c, span);
    }
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
