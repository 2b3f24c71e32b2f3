// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "ideotype/canopy/scene.hpp"
#include "ideotype/physiology/photosynthesis.hpp"

namespace ideotype {

struct Draft;
class Problems;
struct Section;

//! The [water] table as it is written.
struct WaterTable {
    LeafWater rules;
    Stomata::Model model = Stomata::Model::medlyn;
    std::optional<double> intercept{}, slope{};
    double limit = 0;  //!< most transpiration on all days [mm]; 0: any
};

Section water_section(WaterTable& table);

//! Returns the stomata of leaves of some photosynthesis. Numbers that the table
//! lacks are those of the kind of leaf: Medlyn's slope of C4 plants, or of the
//! leaf by Farquhar, and those of maize by Ball and Berry.
Stomata to_stomata(const WaterTable& table,
                   const Photosynthesis& photosynthesis);

//! Reports leaves whose photosynthesis does not depend on CO2, and objectives
//! that need the table [water] where it is missing.
void check_water(const Draft& draft, const Problems& problems);

}  // namespace ideotype
