// SPDX-License-Identifier: Apache-2.0
#include "ideotype/crop/growth.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/points.hpp"
#include "ideotype/crop/leaf_surface.hpp"

namespace ideotype {

namespace {

//! Maps a value linearly from [first, last] to [0, 1]; values outside are
//! clamped.
double ramp(double value, double first, double last) {
    if (value <= first) return 0;
    return value >= last ? 1 : (value - first) / (last - first);
}

//! Returns the thermal time from tip to collar, piecewise linear in rank.
double extension(const Growth& growth, double rank) {
    constexpr double slowest_rank = 0.45;  // relative to number of leaves
    const double slowest = slowest_rank * growth.leaves;
    if (rank <= slowest)
        return growth.first_extension +
               (growth.longest_extension - growth.first_extension) *
                   (rank - 1) / (slowest - 1);
    return growth.longest_extension +
           (growth.last_extension - growth.longest_extension) *
               (rank - slowest) / (growth.leaves - slowest);
}

//! Returns the area of a full-grown blade, see leaf_dates().
double final_area(const Growth& growth, double rank) {
    const double largest = growth.largest * growth.leaves;
    const double x = (rank - largest) / (largest - 1);
    return growth.largest_area *
           std::exp(-growth.narrowing * x * x + growth.skewness * x * x * x);
}

//! Returns the thermal time at which a blade begins to fade.
double death(const Growth& growth, int rank) {
    constexpr double lower_leaves = 0.4;  // relative to number of leaves
    const int lower = static_cast<int>(lower_leaves * growth.leaves);
    if (rank <= lower)
        return growth.lower_death + growth.lower_interval * (rank - 1);
    return silking_time(growth) + growth.upper_death +
           growth.upper_interval * (rank - lower - 1);
}

//! Interpolates values that are given at equal steps from silking to maturity.
//! Before silking, the first value applies.
double after_silking(const Growth& growth, std::span<const double> points,
                     double thermal_time) {
    IDEOTYPE_EXPECT(!points.empty());
    const double share =
        ramp(thermal_time, silking_time(growth), maturity_time(growth));
    return value_between(points,
                         share * static_cast<double>(points.size() - 1));
}

//! Returns the number of leaves below the lowest leaf of the plant.
//! @throws Error if the plant has more leaves than `growth`.
std::size_t leaves_below(const Growth& growth, const Plant& plant) {
    const auto leaves = static_cast<std::size_t>(growth.leaves);
    if (plant.leaves.size() > leaves)
        throw Error(fmt::format(
            "{} has {} leaves, more than the {} that grow ([growth] leaves of "
            "its crop); give the plant fewer, or the crop more",
            plant.name.empty() ? "the plant" : plant.name, plant.leaves.size(),
            leaves));
    return leaves - plant.leaves.size();
}

}  // namespace

double silking_time(const Growth& growth) {
    return growth.leaves * growth.interval + growth.silking;
}

double maturity_time(const Growth& growth) {
    return silking_time(growth) + growth.maturity;
}

double development_stage(const Growth& growth, double thermal_time) {
    const double silking = silking_time(growth);
    return ramp(thermal_time, 0, silking) +
           ramp(thermal_time, silking, maturity_time(growth));
}

double find_thermal_time(const Growth& growth, double stage) {
    return stage <= 1 ? stage * silking_time(growth)
                      : silking_time(growth) + (stage - 1) * growth.maturity;
}

double capacity_factor(const Growth& growth, double thermal_time) {
    return after_silking(growth, growth.ageing, thermal_time);
}

double maintenance_factor(const Growth& growth, double thermal_time) {
    return after_silking(growth, growth.maintenance, thermal_time);
}

std::vector<LeafDates> leaf_dates(const Growth& growth) {
    // The first leaf is partly visible when the plant emerges.
    constexpr double ahead = 10;
    std::vector<LeafDates> leaves;
    for (int rank = 1; rank <= growth.leaves; ++rank) {
        const double tip = std::max(0., (rank - 1) * growth.interval - ahead);
        leaves.push_back({tip, tip + extension(growth, rank),
                          death(growth, rank), final_area(growth, rank)});
    }
    return leaves;
}

double visible_share(const LeafDates& leaf, double thermal_time) {
    return ramp(thermal_time, leaf.tip, leaf.collar);
}

double faded_share(const Growth& growth, const LeafDates& leaf,
                   double thermal_time) {
    return ramp(thermal_time, leaf.death, leaf.death + growth.fading);
}

BladeArea blade_area(const Growth& growth, const LeafDates& leaf,
                     double thermal_time) {
    const double visible = leaf.area * visible_share(leaf, thermal_time);
    const double faded = faded_share(growth, leaf, thermal_time);
    return {visible * (1 - faded), visible * faded};
}

std::vector<double> final_collar_heights(const Growth& growth,
                                         const Plant& plant) {
    const std::size_t below = leaves_below(growth, plant);
    std::vector<double> heights;
    for (std::size_t i = 0; i < below; ++i)
        heights.push_back(plant.leaves.front().insertion_height *
                          static_cast<double>(i + 1) /
                          static_cast<double>(below + 1));
    for (const Leaf& leaf : plant.leaves)
        heights.push_back(leaf.insertion_height);
    return heights;
}

std::vector<double> collar_heights(const Growth& growth,
                                   std::span<const double> final_heights,
                                   double sheath, double thermal_time) {
    const std::vector<LeafDates> leaves = leaf_dates(growth);
    std::vector<double> heights;
    double stem = 0, final_stem = 0;
    bool is_full = true;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        const double sheath_length = std::min(sheath, final_heights[i]);
        const double internode =
            std::max(0., final_heights[i] - sheath_length - final_stem);
        final_stem += internode;
        const double grown =
            growth.internode_rate * (thermal_time - leaves[i].collar);
        is_full = is_full && grown >= internode;
        stem += std::clamp(grown, 0., internode);
        // Fully grown parts get exactly their final height, without the
        // rounding errors of the sum.
        heights.push_back(
            is_full ? final_heights[i]
                    : stem + sheath_length *
                                 visible_share(leaves[i], thermal_time));
    }
    return heights;
}

Plant complete_plant(const Growth& growth, const Plant& plant) {
    const std::size_t below = leaves_below(growth, plant);
    const std::vector<double> heights = final_collar_heights(growth, plant);
    Plant complete = plant;
    for (std::size_t i = below; i > 0; --i) {
        const double size =
            std::sqrt(final_area(growth, static_cast<double>(i)) /
                      final_area(growth, static_cast<double>(below + 1)));
        Leaf leaf = plant.leaves.front();
        leaf.length *= size;
        leaf.width *= size;
        leaf.insertion_height = heights[i - 1];
        // Azimuths alternate between the azimuths of the two lowest leaves.
        leaf.azimuth =
            plant.leaves
                .at((below - i) % 2 == 0
                        ? std::min<std::size_t>(1, plant.leaves.size() - 1)
                        : 0)
                .azimuth;
        complete.leaves.insert(complete.leaves.begin(), std::move(leaf));
    }
    for (Organ& organ : complete.organs)
        if (organ.leaf > 0) organ.leaf += static_cast<int>(below);
    return complete;
}

namespace {

//! Turns a full-grown blade into the blade at a thermal time, see age_plant().
void unfold(Leaf& leaf, const Blade& blade, double visible, double faded) {
    constexpr double least_angle = 0.3, hanging = 40;
    if (visible < 1) {
        leaf.hidden = 1 - length_from_tip(blade, visible);
        leaf.insertion_angle *= std::lerp(least_angle, 1., visible);
        leaf.curvature *= visible;
    }
    if (faded > 0) {
        leaf.dead =
            std::min(length_from_tip(blade, faded * visible), 1 - leaf.hidden);
        leaf.curvature += hanging * faded;
    }
}

}  // namespace

void age_organs(const Growth& growth, double thermal_time, Plant& plant) {
    const double factor = maintenance_factor(growth, thermal_time);
    plant.stalk.maintenance *= factor;
    plant.sheath.maintenance *= factor;
    for (Organ& organ : plant.organs) {
        organ.maintenance *= factor;
        if (organ.senescence > 0 &&
            thermal_time >= silking_time(growth) + organ.senescence) {
            organ.material = PlantMaterial::stalk;
            organ.capacity = organ.maintenance = 0;
        }
    }
}

Plant age_plant(const Growth& growth, const Plant& plant, double thermal_time) {
    constexpr double last = 100, least_height = 0.001;
    const std::vector<LeafDates> dates = leaf_dates(growth);
    const std::vector<double> heights =
        collar_heights(growth, final_collar_heights(growth, plant),
                       plant.sheath.length, thermal_time);
    Plant grown = complete_plant(growth, plant);
    double top = least_height;
    bool is_full = true;
    for (std::size_t i = 0; i < grown.leaves.size(); ++i) {
        Leaf& leaf = grown.leaves[i];
        const double visible = visible_share(dates[i], thermal_time);
        is_full =
            is_full && visible == 1 && heights[i] == leaf.insertion_height;
        // A blade emerges from the top of the whorl.
        leaf.insertion_height =
            visible < 1 ? std::max(top, heights[i]) : heights[i];
        top = std::max(top, leaf.insertion_height);
        unfold(leaf, grown.blade, visible,
               faded_share(growth, dates[i], thermal_time));
    }
    if (!is_full) grown.stalk.height = std::min(grown.stalk.height, top);
    // Other organs grow shortly before silking.
    const double silking = silking_time(growth);
    const double size = ramp(thermal_time, silking - last, silking);
    for (Organ& organ : grown.organs) {
        organ.is_present = organ.is_present && size > 0;
        for (double* length : {&organ.offset, &organ.spread, &organ.length})
            if (size < 1) *length *= size;
    }
    age_organs(growth, thermal_time, grown);
    return grown;
}

double daily_thermal_time(const Growth& growth,
                          std::span<const double> temperatures) {
    double sum = 0;
    for (const double temperature : temperatures)
        sum += std::clamp(temperature, growth.base, growth.cap) - growth.base;
    return temperatures.empty()
               ? 0
               : sum / static_cast<double>(temperatures.size());
}

}  // namespace ideotype
