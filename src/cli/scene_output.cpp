// SPDX-License-Identifier: Apache-2.0
#include "scene_output.hpp"

#include <fmt/format.h>

#include "run/progress.hpp"

namespace ideotype {

namespace {

//! A number of each band, which `take` finds, as a fraction of its light.
template <class Take>
Json by_band(const CanopyReport& report, const Take& take) {
    Json json = Json::object();
    for (const BandReport& band : report.bands)
        json[band.name] =
            to_json(fraction_of(take(band), band.light.day.incident));
    return json;
}

Estimate lowered(Estimate gross, double loss) {
    return {gross.mean - loss, gross.standard_error};
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
            const auto part = [&](Estimate x) {
                Json rate = to_json(scaled(x, assimilation_scale(span)));
                rate["unit"] = assimilation_unit(span);
                return rate;
            };
            const auto& [gross, respiration, building] = assimilation[c];
            one["assimilation"] = {
                {"gross", part(gross)},
                {"net", part(lowered(gross, respiration.in_light))}};
        }
        json[component.name] = std::move(one);
    }
    return json;
}

}  // namespace

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
    // Names differ; to look each up among the others takes too long.
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

void print_scene(const CanopyReport& report, Span span) {
    fmt::print("\n{:<20}", "fraction of incident");
    for (const BandReport& band : report.bands)
        fmt::print(" {:>24}", band.name);
    fmt::print("\n");
    const auto line = [&](const std::string& name, const auto& take) {
        fmt::print("{:<20}", name);
        for (const BandReport& band : report.bands)
            fmt::print(" {:>24}", format(fraction_of(take(band),
                                                     band.light.day.incident)));
        fmt::print("\n");
    };
    for (std::size_t c = 0; c < report.components.size(); ++c)
        line(report.components[c].name,
             [&](const BandReport& band) { return band.part(c).all; });
    line("soil", [](const BandReport& band) { return band.light.day.soil; });
    line("reflected",
         [](const BandReport& band) { return band.light.day.reflected; });
    fmt::print("\n{:<20} {:>12}\n", "component", "LAI");
    for (const ComponentReport& each : report.components)
        fmt::print("{:<20} {:>12.4g}\n", each.name, each.lai);
    if (!report.assimilation) return;
    fmt::print("\n{:<20} {:>24} {:>24}\n",
               fmt::format("CO2 [{}]", assimilation_unit(span)),
               "gross assimilation", "net");
    const std::vector<ComponentAssimilation> all = by_component(
        *report.assimilation, report.groups, report.components.size());
    const double scale = assimilation_scale(span);
    for (std::size_t c = 0; c < all.size(); ++c)
        if (report.components[c].assimilates)
            fmt::print("{:<20} {:>24} {:>24}\n", report.components[c].name,
                       format(scaled(all[c].gross, scale)),
                       format(scaled(
                           lowered(all[c].gross, all[c].respiration.in_light),
                           scale)));
}

}  // namespace ideotype
