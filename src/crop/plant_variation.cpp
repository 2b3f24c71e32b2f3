// SPDX-License-Identifier: Apache-2.0
#include "ideotype/crop/plant_variation.hpp"

#include <algorithm>
#include <cmath>

namespace ideotype {

namespace {

//! Draws from a Laplace distribution with a standard deviation of 1.
double laplace(RandomStream& random) {
    const double x = random.uniform(-1, 1);
    return std::copysign(std::log1p(-std::abs(x)) / std::sqrt(2.0), x);
}

//! Selects the standard deviation that applies to a leaf.
double select_deviation(const LeafSpread& spread, std::size_t leaf,
                        std::size_t leaves) {
    return spread[leaf * spread.size() / leaves];
}

}  // namespace

bool PlantVariation::is_any() const {
    const auto is_wide = [](const LeafSpread& spread) {
        return std::any_of(spread.begin(), spread.end(),
                           [](double deviation) { return deviation > 0; });
    };
    return position > 0 || position_across > 0 || length > 0 || width > 0 ||
           height > 0 || missing > 0 || late > 0 || is_wide(insertion_angle) ||
           is_wide(azimuth) || is_wide(curvature) || is_wide(roll) ||
           is_wide(twist);
}

double cut_deviation(double deviation) {
    return std::clamp(deviation, -most_deviations, most_deviations);
}

Plant deviating(Plant plant, const PlantVariation& variation,
                RandomStream& random, double side) {
    const auto cut = [&](double deviation) {
        return side * cut_deviation(deviation);
    };
    const double higher = 1 + variation.height * cut(random.normal()[0]);
    plant.stalk.height *= higher;
    plant.sheath.length *= higher;
    const std::size_t leaves = plant.leaves.size();
    for (std::size_t i = 0; i < leaves; ++i) {
        Leaf& leaf = plant.leaves[i];
        leaf.insertion_height *= higher;
        const auto [length, width] = random.normal();
        const auto [angle, azimuth] = random.normal();
        const auto [curvature, roll] = random.normal();
        const double twist = laplace(random);
        const auto deviation = [&](const LeafSpread& spread, double deviate) {
            return select_deviation(spread, i, leaves) * cut(deviate);
        };
        leaf.length *= 1 + variation.length * cut(length);
        leaf.width *= 1 + variation.width * cut(width);
        leaf.insertion_angle += deviation(variation.insertion_angle, angle);
        leaf.azimuth += deviation(variation.azimuth, azimuth);
        leaf.curvature += deviation(variation.curvature, curvature);
        // The formula for the midrib is meant only for leaves that lean
        // outwards.
        if (leaf.midrib.empty()) {
            leaf.insertion_angle = std::abs(leaf.insertion_angle);
            leaf.curvature = std::max(0.0, leaf.curvature);
        }
        leaf.roll += deviation(variation.roll, roll);
        leaf.twist += deviation(variation.twist, twist);
    }
    return plant;
}

double furthest(const Plant& plant, const Leaf& leaf,
                const PlantVariation& variation) {
    return (1 + most_deviations * variation.height) * leaf.insertion_height +
           leaf.petiole_length + plant.blade.rachis_length +
           (1 + most_deviations * variation.length) * leaf.length;
}

Plant scaled(Plant plant, double size) {
    for (Leaf& leaf : plant.leaves) {
        leaf.length *= size;
        leaf.width *= size;
        leaf.insertion_height *= size;
        leaf.petiole_length *= size;
        leaf.internode *= size;
    }
    for (double* length : {&plant.stalk.height, &plant.stalk.base_diameter,
                           &plant.stalk.top_diameter, &plant.sheath.length,
                           &plant.petiole.diameter, &plant.blade.rachis_length})
        *length *= size;
    for (Organ& organ : plant.organs)
        for (double* length : {&organ.offset, &organ.spread, &organ.length,
                               &organ.base_diameter, &organ.top_diameter})
            *length *= size;
    return plant;
}

}  // namespace ideotype
