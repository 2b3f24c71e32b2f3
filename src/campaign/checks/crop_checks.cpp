// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>

#include "checks.hpp"
#include "ideotype/crop/measures.hpp"

namespace ideotype {

namespace {

//! @param problems problems of the crop
void check_leaves(const Plant& plant, const Problems& problems) {
    const double stalk = plant.stalk.height;
    for (std::size_t i = 0; i < plant.leaves.size(); ++i) {
        const Leaf& leaf = plant.leaves[i];
        const Problems own = problems.in("leaf", i);
        const double height = leaf.insertion_height;
        if (Leaf line = leaf; !leaf.midrib.empty() && !measure_midrib(line))
            own.add("midrib",
                    "leaf.midrib has no two points that differ (a line needs a "
                    "direction); give the points from the base to the tip");
        if (own.usable({"length", "width"}) && leaf.width > leaf.length)
            own.add("width",
                    "leaf.width is {} m (wider than its length of {} m); check "
                    "the units: both are in m",
                    leaf.width, leaf.length);
        if (own.usable({"insertion_height"}) &&
            problems.usable({"stalk.height"}) && height > stalk)
            own.add("insertion_height",
                    "leaf.insertion_height is {} m (above the stalk's height "
                    "of {} m); use {} m or less",
                    height, stalk, stalk);
        if (i == 0 || !own.usable({"insertion_height"}) ||
            !problems.in("leaf", i - 1).usable({"insertion_height"}))
            continue;
        const double below = plant.leaves[i - 1].insertion_height;
        if (height < below)
            own.add("insertion_height",
                    "leaf.insertion_height is {} m (below the leaf before it, "
                    "at {} m); list the lowest leaf first",
                    height, below);
    }
}

void check_blade(const Blade& blade, const Problems& problems) {
    constexpr double least = 1e-6;  // smaller maxima cannot be scaled
    if (problems.usable({"width_controls"}) &&
        std::ranges::max(blade.width_controls) < least)
        problems.add("width_controls",
                     "blade.width_controls are all 0 (a blade has a width); "
                     "leave the key out for the usual profile");
    if (problems.usable({"leaflets", "leaflet_divergence"}) &&
        blade.leaflets > 1 && blade.leaflet_divergence == 0)
        problems.add("leaflets",
                     "blade.leaflets is {} (all of them would point the same "
                     "way); give their leaflet_divergence, such as 80 deg",
                     blade.leaflets);
}

//! Checks names of organs, with which names of measures begin.
//! @param problems problems of the crop
void check_organs(const Plant& plant, const Problems& problems) {
    std::set<std::string> names{"leaf", "blade", "stalk", "sheath", "petiole"};
    for (std::size_t i = 0; i < plant.organs.size(); ++i) {
        const Organ& organ = plant.organs[i];
        const Problems own = problems.in("organ", i);
        if (own.usable({"name"}) && !names.insert(organ.name).second)
            own.add("name",
                    "organ.name is \"{}\" (already used); give each organ a "
                    "name of its own",
                    organ.name);
        if (own.usable({"leaf"}) &&
            organ.leaf > static_cast<int>(plant.leaves.size()))
            own.add("leaf",
                    "organ.leaf is {} (the plant has {} leaves); use one of "
                    "them, or 0 for the stalk's top",
                    organ.leaf, plant.leaves.size());
    }
}

//! Reports growth whose dates contradict each other or the plant.
void check_growth(const CropSpec& crop, const Problems& problems) {
    if (!crop.growth || !problems.usable({"leaves"})) return;
    const Growth& growth = *crop.growth;
    const auto leaves = static_cast<int>(crop.baseline.leaves.size());
    if (growth.leaves < leaves)
        problems.add("leaves",
                     "growth.leaves is {} (the plant has {} leaves, the "
                     "highest of those that grow); use {} or more",
                     growth.leaves, leaves, leaves);
    for (const auto& [name, share] : {std::pair("largest", growth.largest),
                                      std::pair("slowest", growth.slowest)})
        if (problems.usable({name}) && share * growth.leaves <= 1)
            problems.add(name,
                         "growth.{} is {} (a rank below the second of {} "
                         "leaves); use more than {:.3g}",
                         name, share, growth.leaves, 1. / growth.leaves);
    for (const auto& [name, points] :
         {std::pair("ageing", &growth.ageing),
          std::pair("maintenance", &growth.maintenance)})
        if (problems.usable({name}) && points->front() != 1)
            problems.add(name,
                         "growth.{} begins with {} (it is relative to plants "
                         "before silking, where it begins); begin with 1",
                         name, points->front());
}

//! Reports a development stage of plants that grow, and warns of one that
//! changes nothing.
void check_stage(const Spec& spec, const Problems& problems) {
    const double stage = spec.plant.stage;
    if (stage == PlantSpec().stage || !problems.usable({"plant.stage"})) return;
    if (plants_grow(spec))
        return problems.add("plant.stage",
                            "plant.stage is {} (plants pass through all "
                            "stages from climate.emergence on); remove it",
                            stage);
    const auto ages = [](const CropSpec& crop) {
        return !crop.is_known ||
               (crop.growth && crop.growth->ageing.size() > 1);
    };
    if (!ages(spec.plant.crop) &&
        std::ranges::none_of(spec.components, ages, &ComponentSpec::crop))
        problems.warn("plant.stage",
                      "plant.stage is {} (no crop file has growth.ageing, so "
                      "that leaves do not age); give it to the crop file, or "
                      "remove plant.stage",
                      stage);
}

//! Reports emergence outside of its period, or without weather to grow by.
//! @param problems problems of the climate
void check_emergence(const Spec& spec, const Named<Climate>& named,
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
    if (spec.plant.crop.is_known && !spec.plant.crop.growth)
        return add(
            "(the crop file does not tell how plants grow); add [growth] to "
            "it, which describes a hybrid of maize if it is empty");
    const Growth growth = spec.plant.crop.growth.value_or(Growth());
    for (const SiteWeather& weather : spec.weathers) {
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
                    growth, {weather.temperature.data() + d * steps, steps});
        if (!(sum > leaf_dates(growth).front().collar))
            return add(
                fmt::format("(until the end of the period there are {:.0f} deg "
                            "C d, too few for a leaf); give a longer period",
                            sum));
        if (sum < maturity_time(growth))
            problems.warn("emergence",
                          "plants of climate \"{}\" are not mature at the end "
                          "of the period, with {:.0f} of {:.0f} deg C d; take "
                          "a longer period, if the weather file has one",
                          named.name, sum, maturity_time(growth));
    }
}

//! Reports leaves that cannot grow by coming out of a whorl.
//! @param problems problems of the crop
void check_leaves(const CropSpec& crop, const Problems& problems) {
    const Plant& plant = crop.baseline;
    if (crop.is_known && crop.growth &&
        (plant.blade.leaflets > 1 || has_petioles(plant)))
        problems.add("growth.leaves",
                     "growth.leaves describes grasses, whose blades come out "
                     "tip first (this plant has petioles or leaflets); leave "
                     "out climate.emergence, or [growth] of this crop");
}

}  // namespace

void check_plant(const CropSpec& crop, const Problems& problems) {
    const Plant& plant = crop.baseline;
    check_blade(plant.blade, problems.in("blade"));
    check_leaves(plant, problems);
    check_organs(plant, problems);
    check_growth(crop, problems.in("growth"));
    check_traits(crop, problems);
}

void check_growing(const Spec& spec, const Problems& problems) {
    const auto& climates = spec.climates;
    const bool grows = plants_grow(spec);
    check_stage(spec, problems);
    for (std::size_t i = 0; i < climates.size(); ++i) {
        const Problems own = problems.in("climate", i);
        if (climates[i].value.grows())
            check_emergence(spec, climates[i], own);
        else if (grows)
            own.add("name",
                    "climate \"{}\" has no emergence (plants grow in another "
                    "climate); give emergence to each",
                    climates[i].name);
    }
    if (grows) check_leaves(spec.plant.crop, problems.in("plant.baseline"));
    for (std::size_t i = 0; i < spec.components.size(); ++i) {
        const ComponentSpec& each = spec.components[i];
        const Problems own = problems.in("component", i);
        if (grows) check_leaves(each.crop, own.in("crop"));
        if (each.later > 0 && (!grows || !each.crop.growth))
            own.add("later",
                    "component.later is given (only plants that grow can be "
                    "later); remove it, or give [growth] to its crop file and "
                    "emergence to each [[climate]]");
    }
}

}  // namespace ideotype
