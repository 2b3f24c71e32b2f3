// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "checks.hpp"
#include "ideotype/canopy/quantities.hpp"

namespace ideotype {

namespace {

//! Reports a day of emergence that is not of its period, or without weather
//! that plants could grow by.
void check_emergence(const Draft& draft, const Named<Climate>& named,
                     Problems& problems) {
    const Climate& climate = named.value;
    const Date& day = climate.emergence;
    if (!problems.usable({&day, &climate.period.from, &climate.period.to}))
        return;
    const auto add = [&](const std::string& why) {
        problems.add(&day, fmt::format("climate.emergence is {} {}",
                                       to_string(day), why));
    };
    if (day < climate.period.from || day > climate.period.to)
        return add(fmt::format(
            "(the period is from {} to {}); give a day of "
            "it, or a longer period",
            to_string(climate.period.from), to_string(climate.period.to)));
    if (draft.is_crop_known && !draft.has_growth)
        return add(
            "(the crop file tells no growth); add [growth] to it, an "
            "empty one has a hybrid of maize");
    for (const SiteWeather& weather : draft.campaign.weathers) {
        if (weather.climate != named.name || !problems.empty()) continue;
        if (weather.temperature.empty())
            return add(
                "(the weather has no temperature, which growth "
                "follows); name its column");
        double sum = 0;
        const std::size_t steps = weather.hours.size();
        for (std::size_t d = 0; d < weather.dates.size(); ++d)
            if (weather.dates[d] >= day)
                sum += daily_thermal_time(
                    draft.growth,
                    {weather.temperature.data() + d * steps, steps});
        if (!(sum > leaf_dates(draft.growth).front().collar))
            return add(
                fmt::format("(until the end of the period there are "
                            "{:.0f} deg C d, too few for a leaf); give "
                            "a longer period",
                            sum));
        if (sum < maturity_time(draft.growth))
            problems.warn(
                &day,
                fmt::format("plants of climate \"{}\" are not mature at the "
                            "end of the period, with {:.0f} of {:.0f} deg C d; "
                            "take a longer one, if the weather file has it",
                            named.name, sum, maturity_time(draft.growth)));
    }
}

//! Reports leaves that do not grow by coming out of a whorl.
void check_leaves(const Draft& crop, Problems& problems) {
    const Plant& plant = crop.campaign.crop.baseline;
    if (crop.is_crop_known && crop.has_growth &&
        (plant.blade.leaflets > 1 || has_petioles(plant)))
        problems.add(
            &crop.growth.leaves,
            "growth.leaves are those of grasses, whose blades come out "
            "tip first (this plant has petioles or leaflets); leave "
            "out climate.emergence, or [growth] of this crop");
}

}  // namespace

void check_growing(const Draft& draft, Problems& problems) {
    const auto& climates = draft.campaign.climates;
    const auto growing =
        std::count_if(climates.begin(), climates.end(),
                      [](const auto& each) { return each.value.grows(); });
    for (const Named<Climate>& each : climates)
        if (each.value.grows())
            check_emergence(draft, each, problems);
        else if (growing > 0)
            problems.add(&each.name,
                         fmt::format("climate \"{}\" has no emergence (plants "
                                     "grow in another); give one to each",
                                     each.name));
    if (growing > 0) check_leaves(draft, problems);
    for (const std::shared_ptr<Draft>& each : draft.components) {
        if (growing > 0) check_leaves(*each, problems);
        if (each->standing.later > 0 && (growing == 0 || !each->has_growth))
            problems.add(
                &each->standing.later,
                "component.later is for plants that grow; remove it, or "
                "give [growth] to its crop file and emergence to each "
                "[[climate]]");
    }
    if (growing > 0) return;
    for (const auto* list :
         {&draft.campaign.maximised, &draft.campaign.minimised})
        for (const std::string& each : *list)
            if (problems.usable({list}) && is_of_growth(each))
                problems.add(list, fmt::format("the objective {} is of plants "
                                               "that grow; add emergence to "
                                               "[[climate]]",
                                               each));
}

}  // namespace ideotype
