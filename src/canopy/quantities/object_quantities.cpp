// SPDX-License-Identifier: Apache-2.0
#include "declaration.hpp"
#include "ideotype/core/units.hpp"
#include "randomised.hpp"

namespace ideotype {

namespace {

using Values = std::vector<Estimate>;

bool has_objects(const Scope& scope) {
    return scope.has_objects;
}

//! Returns the light incident on the ground, computed from the light it
//! absorbs; 0 if it absorbs none.
Estimate on_ground(const BandReport& band, const Estimate& absorbed) {
    const double kept = 1 - band.soil_albedo;
    return kept > 0 ? scaled(absorbed, 1 / kept) : Estimate{};
}

Values ground_light(const CanopyReport& report) {
    return mapped(report.bands, [](const BandReport& band) {
        return scaled(on_ground(band, band.light.day.soil),
                      1 / joule_per_megajoule);
    });
}

Values ground_light_by_hour(const CanopyReport& report) {
    Values values;
    for (const BandReport& band : report.bands)
        for (const StepReport& step : band.light.steps)
            values.push_back(on_ground(band, step.budget.soil));
    return values;
}

Values object_light(const CanopyReport& report) {
    Values values;
    for (std::size_t side = 0; side < 2 * report.objects.size(); ++side)
        for (const BandReport& band : report.bands)
            values.push_back(
                scaled(band.objects[side].day, 1 / joule_per_megajoule));
    return values;
}

Values object_light_by_hour(const CanopyReport& report) {
    Values values;
    for (std::size_t side = 0; side < 2 * report.objects.size(); ++side)
        for (const BandReport& band : report.bands)
            for (const Estimate& hour : band.objects[side].hours)
                values.push_back(hour);
    return values;
}

}  // namespace

Randomised light_on_panels(const CanopyReport& report) {
    std::vector<double> sums(report.randomisations());
    for (const BandReport& band : report.bands)
        for (std::size_t side = 0; side < band.objects.size(); ++side) {
            const ObjectReport& object = report.objects[side / 2];
            if (!object.is_panel) continue;
            for (std::size_t r = 0; r < sums.size(); ++r)
                sums[r] += object.area_index / joule_per_megajoule *
                           band.objects[side].by_randomisation[r];
        }
    return known_to(0, std::move(sums));
}

std::vector<Declaration> object_quantities() {
    return {
        {{"panel_light", daily,
          "light on both sides of panels per ground area, in all wavebands "
          "together"},
         MeanOver::nothing,
         TakeNumber(light_on_panels),
         [](const Scope& scope) { return scope.has_panels; }},
        {by({"band"},
            {"ground_light", daily, "light that falls on the ground"}),
         MeanOver::nothing, ground_light, has_objects},
        {by({"band", "hour"},
            {"ground_light_by_hour", "W m-2",
             "light that falls on the ground at each instant"}),
         MeanOver::time, ground_light_by_hour, has_objects},
        {by({"object", "object_side", "band"},
            {"object_light", daily,
             "light that falls on a side of an object per area of that side; 0 "
             "where it absorbs none"}),
         MeanOver::nothing, object_light, has_objects},
        {by({"object", "object_side", "band", "hour"},
            {"object_light_by_hour", "W m-2",
             "light that falls on a side of an object at each instant, per "
             "area of that side"}),
         MeanOver::time, object_light_by_hour, has_objects},
    };
}

}  // namespace ideotype
