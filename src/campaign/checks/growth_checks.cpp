// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "checks.hpp"

namespace ideotype {

namespace {

//! Reports emergence outside of its period, or without weather to grow by.
//! @param problems problems of the climate
void check_emergence(const Draft& draft, const Named<Climate>& named,
                     const Problems& problems) {
    const auto& [from, to] = named.value.period;
    const Date& day = named.value.emergence;
    if (!problems.usable({"emergence", "from", "to"})) return;
    const auto add = [&](const std::string& why) {
        problems.add("emergence", "climate.emergence is {} {}", to_string(day),
                     why);
    };
    if (day < from || day > to)
        return add(
            fmt::format("(the period is from {} to {}); give a day of it, or a "
                        "longer period",
                        to_string(from), to_string(to)));
    if (draft.is_crop_known && !draft.has_growth)
        return add(
            "(the crop file does not tell how plants grow); add [growth] to "
            "it, which describes a hybrid of maize if it is empty");
    for (const SiteWeather& weather : draft.campaign.weathers) {
        if (weather.climate != named.name || !problems.empty()) continue;
        if (weather.temperature.empty())
            return add(
                "(the weather has no temperature, which growth follows); name "
                "its column");
        double sum = 0;
        const std::size_t steps = weather.hours.size();
        for (std::size_t d = 0; d < weather.dates.size(); ++d)
            if (weather.dates[d] >= day)
                sum += daily_thermal_time(
                    draft.growth,
                    {weather.temperature.data() + d * steps, steps});
        if (!(sum > leaf_dates(draft.growth).front().collar))
            return add(
                fmt::format("(until the end of the period there are {:.0f} deg "
                            "C d, too few for a leaf); give a longer period",
                            sum));
        if (sum < maturity_time(draft.growth))
            problems.warn("emergence",
                          "plants of climate \"{}\" are not mature at the end "
                          "of the period, with {:.0f} of {:.0f} deg C d; take "
                          "a longer period, if the weather file has one",
                          named.name, sum, maturity_time(draft.growth));
    }
}

//! Reports leaves that cannot grow by coming out of a whorl.
//! @param problems problems of the crop
void check_leaves(const Draft& crop, const Problems& problems) {
    const Plant& plant = crop.campaign.crop.baseline;
    if (crop.is_crop_known && crop.has_growth &&
        (plant.blade.leaflets > 1 || has_petioles(plant)))
        problems.add("growth.leaves",
                     "growth.leaves describes grasses, whose blades come out "
                     "tip first (this plant has petioles or leaflets); leave "
                     "out climate.emergence, or [growth] of this crop");
}

}  // namespace

void check_growing(const Draft& draft, const Problems& problems) {
    const auto& climates = draft.campaign.climates;
    const bool grows = plants_grow(draft.campaign);
    for (std::size_t i = 0; i < climates.size(); ++i) {
        const Problems own = problems.in("climate", i);
        if (climates[i].value.grows())
            check_emergence(draft, climates[i], own);
        else if (grows)
            own.add("name",
                    "climate \"{}\" has no emergence (plants grow in another "
                    "climate); give emergence to each",
                    climates[i].name);
    }
    if (grows) check_leaves(draft, problems.in("plant.baseline"));
    for (std::size_t i = 0; i < draft.components.size(); ++i) {
        const Draft& each = *draft.components[i];
        const Problems own = problems.in("component", i);
        if (grows) check_leaves(each, own.in("crop"));
        if (each.standing.later > 0 && (!grows || !each.has_growth))
            own.add("later",
                    "component.later is given (only plants that grow can be "
                    "later); remove it, or give [growth] to its crop file and "
                    "emergence to each [[climate]]");
    }
}

}  // namespace ideotype
