// SPDX-License-Identifier: Apache-2.0
#include "ideotype/crop/plant_variation.hpp"

#include <algorithm>
#include <cmath>

namespace ideotype {

bool PlantVariation::is_any() const {
    return length > 0 || width > 0 || insertion_angle > 0 || azimuth > 0 ||
           height > 0;
}

Plant deviating(Plant plant, const PlantVariation& variation,
                RandomStream& random) {
    static constexpr double furthest = 3;
    const auto cut = [](double deviation) {
        return std::clamp(deviation, -furthest, furthest);
    };
    const double higher = 1 + variation.height * cut(random.normal()[0]);
    plant.stalk.height *= higher;
    plant.sheath.length *= higher;
    for (Leaf& leaf : plant.leaves) {
        leaf.insertion_height *= higher;
        const auto [of_length, of_width] = random.normal();
        const auto [of_angle, of_azimuth] = random.normal();
        leaf.length *= 1 + variation.length * cut(of_length);
        leaf.width *= 1 + variation.width * cut(of_width);
        leaf.insertion_angle = std::abs(
            leaf.insertion_angle + variation.insertion_angle * cut(of_angle));
        leaf.azimuth += variation.azimuth * cut(of_azimuth);
    }
    return plant;
}

}  // namespace ideotype
