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
    const auto height_key = [](std::size_t leaf) {
        return fmt::format("leaf[{}].insertion_height", leaf);
    };
    for (std::size_t i = 0; i < plant.leaves.size(); ++i) {
        const Leaf& leaf = plant.leaves[i];
        const Problems of_leaf = problems.in("leaf", i);
        const double height = leaf.insertion_height;
        const auto has_no_line = [&] {
            Leaf line = leaf;
            return !leaf.midrib.empty() && !measure_midrib(line);
        };
        of_leaf.rule({"midrib"}, has_no_line,
                     "leaf.midrib has no two different points (a line needs a "
                     "direction); give the points from the base to the tip");
        of_leaf.rule(
            {"width", "length"}, leaf.width > leaf.length,
            "leaf.width is {} m (wider than its length of {} m); check "
            "the units: both are in m",
            leaf.width, leaf.length);
        problems.rule({height_key(i), "stalk.height"}, height > stalk,
                      "leaf.insertion_height is {} m (above the stalk's height "
                      "of {} m); use {} m or less",
                      height, stalk, stalk);
        if (i == 0) continue;
        const double below = plant.leaves[i - 1].insertion_height;
        problems.rule({height_key(i), height_key(i - 1)}, height < below,
                      "leaf.insertion_height is {} m (below the leaf before "
                      "it, at {} m); list the lowest leaf first",
                      height, below);
    }
}

void check_blade(const Blade& blade, const Problems& problems) {
    constexpr double least = 1e-6;  // smaller maxima cannot be normalised
    problems.rule(
        {"width_controls"},
        [&] { return std::ranges::max(blade.width_controls) < least; },
        "blade.width_controls are all 0 (a blade has a width); leave the key "
        "out for the usual profile");
    problems.rule({"leaflets", "leaflet_divergence"},
                  blade.leaflets > 1 && blade.leaflet_divergence == 0,
                  "blade.leaflets is {} (all of them would point the same "
                  "way); give their leaflet_divergence, such as 80 deg",
                  blade.leaflets);
}

//! Checks names of organs. Names of measures begin with them.
//! @param problems problems of the crop
void check_organs(const Plant& plant, const Problems& problems) {
    std::set<std::string> names{"leaf", "blade", "stalk", "sheath", "petiole"};
    for (std::size_t i = 0; i < plant.organs.size(); ++i) {
        const Organ& organ = plant.organs[i];
        const Problems of_organ = problems.in("organ", i);
        of_organ.rule(
            ProblemCode::duplicate, {"name"},
            [&] { return !names.insert(organ.name).second; },
            "organ.name is \"{}\" (already used); give each organ a different "
            "name",
            organ.name);
        of_organ.rule(
            {"leaf"}, organ.leaf > static_cast<int>(plant.leaves.size()),
            "organ.leaf is {} (the plant has {} leaves); use one of them, "
            "or 0 for the top of the stalk",
            organ.leaf, plant.leaves.size());
    }
}

//! Reports growth parameters that contradict each other or the plant.
void check_growth(const CropSpec& crop, const Problems& problems) {
    if (!crop.growth) return;
    const Growth& growth = *crop.growth;
    const auto leaves = static_cast<int>(crop.baseline.leaves.size());
    problems.rule({"largest", "leaves"}, growth.largest * growth.leaves <= 1,
                  "growth.largest is {} (a rank below the second of {} "
                  "leaves); use more than {:.3g}",
                  growth.largest, growth.leaves, 1. / growth.leaves);
    for (const auto& [name, points] :
         {std::pair("ageing", &growth.ageing),
          std::pair("maintenance", &growth.maintenance)})
        problems.rule({name}, points->front() != 1,
                      "growth.{} begins with {} (it is relative to plants "
                      "before silking, where it begins); begin with 1",
                      name, points->front());
    problems.rule({"leaves"}, growth.leaves < leaves,
                  "growth.leaves is {} (the plant has {} leaves, the highest "
                  "of those that grow); use {} or more",
                  growth.leaves, leaves, leaves);
}

//! Reports a development stage if plants grow, and warns if it has no effect.
void check_stage(const Spec& spec, const Problems& problems) {
    const double stage = spec.plant.stage;
    const bool is_given = stage != PlantSpec().stage;
    const auto ages = [](const CropSpec& crop) {
        return !crop.is_known ||
               (crop.growth && crop.growth->ageing.size() > 1);
    };
    problems.rule({"plant.stage"}, is_given && plants_grow(spec),
                  "plant.stage is {} (plants pass through all stages from "
                  "climate.emergence on); remove it",
                  stage);
    problems.doubt(
        {"plant.stage"},
        is_given && !ages(spec.plant.crop) &&
            std::ranges::none_of(spec.components, ages, &ComponentSpec::crop),
        "plant.stage is {} (no crop file has growth.ageing, so that leaves do "
        "not age); give it to the crop file, or remove plant.stage",
        stage);
}

//! Returns the thermal time from a date to the end of the weather [deg C d], or
//! 0 if the weather does not include temperature.
double thermal_time_from(const Date& day, const SiteWeather& weather,
                         const Growth& growth) {
    double sum = 0;
    if (weather.temperature.empty()) return sum;
    const std::size_t steps = weather.hours.size();
    for (std::size_t d = 0; d < weather.dates.size(); ++d)
        if (weather.dates[d] >= day)
            sum += daily_thermal_time(
                growth, {weather.temperature.data() + d * steps, steps});
    return sum;
}

//! Reports a date of emergence outside the period of the weather, or weather
//! without temperature.
//! @param problems problems of the climate
void check_emergence(const Spec& spec, const Named<Climate>& named,
                     const Problems& problems) {
    const auto& [from, to] = named.value.period;
    const CropSpec& crop = spec.plant.crop;
    const Date& day = named.value.emergence;
    const Keys keys{"emergence", "from", "to"};
    problems.rule(keys, day < from || day > to,
                  "climate.emergence is {} (the period is from {} to {}); give "
                  "a day of it, or a longer period",
                  to_string(day), to_string(from), to_string(to));
    problems.rule(
        keys, crop.is_known && !crop.growth,
        "climate.emergence is {} (the crop file has no growth parameters); add "
        "[growth] to it, which describes a maize hybrid if it is empty",
        to_string(day));
    const Growth growth = crop.growth.value_or(Growth());
    for (const SiteWeather& weather : spec.weathers) {
        if (weather.climate != named.name || !problems.empty()) continue;
        problems.rule(keys, weather.temperature.empty(),
                      "climate.emergence is {} (the weather has no "
                      "temperature, which growth follows); name its column",
                      to_string(day));
        const double sum = thermal_time_from(day, weather, growth);
        problems.rule(keys, !(sum > leaf_dates(growth).front().collar),
                      "climate.emergence is {} (the period ends after {:.0f} "
                      "deg C d, too few for a leaf); give a longer period",
                      to_string(day), sum);
        problems.doubt(keys, sum < maturity_time(growth),
                       "plants of climate \"{}\" are not mature at the end of "
                       "the period, with {:.0f} of {:.0f} deg C d; use a "
                       "longer period if the weather file covers it",
                       named.name, sum, maturity_time(growth));
    }
}

//! Reports growing plants without a whorl, since the growth model applies only
//! to grasses.
//! @param problems problems of the crop
void check_whorl(const CropSpec& crop, const Problems& problems) {
    const Plant& plant = crop.baseline;
    problems.rule({"growth.leaves"},
                  crop.is_known && crop.growth &&
                      (plant.blade.leaflets > 1 || has_petioles(plant)),
                  "growth.leaves describes grasses, whose blades come out tip "
                  "first (this plant has petioles or leaflets); leave out "
                  "climate.emergence, or [growth] of this crop");
}

}  // namespace

void check_plant(const CropSpec& crop, const Problems& problems) {
    const Plant& plant = crop.baseline;
    check_blade(plant.blade, problems.in("blade"));
    check_leaves(plant, problems);
    check_organs(plant, problems);
    check_growth(crop, problems.in("growth"));
    check_plasticity(crop, problems);
    check_traits(crop, problems);
}

void check_growing(const Spec& spec, const Problems& problems) {
    const auto& climates = spec.climates;
    const bool grows = plants_grow(spec);
    check_stage(spec, problems);
    for (const NamedClimate& climate : climates) {
        const Problems of_climate = problems.in("climate", climate.value.table);
        if (climate.value.grows())
            check_emergence(spec, climate, of_climate);
        else
            of_climate.rule(
                {"name", "emergence"}, grows,
                "climate \"{}\" has no emergence (plants grow in another "
                "climate); give emergence to each",
                climate.name);
    }
    if (grows) check_whorl(spec.plant.crop, problems.in("plant.baseline"));
    for (std::size_t i = 0; i < spec.components.size(); ++i) {
        const ComponentSpec& component = spec.components[i];
        const Problems of_component = problems.in("component", i);
        if (component.has_mesh()) continue;
        if (grows) check_whorl(component.crop, of_component.in("crop"));
        of_component.rule(
            {"later"},
            component.later > 0 && (!grows || !component.crop.growth),
            "component.later is given (only plants that grow can be "
            "later); remove it, or give [growth] to its crop file and "
            "emergence to each [[climate]]");
    }
}

}  // namespace ideotype
