// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "campaign/entries.hpp"
#include "ideotype/canopy/scene.hpp"
#include "ideotype/physiology/photosynthesis.hpp"

namespace ideotype {

class Problems;

//! Returns the photosynthesis that a table describes.
//! @param table table without problems
Photosynthesis to_photosynthesis(const PhotosynthesisSpec& table);

//! Returns the photosynthesis of each component of a campaign, the crop first,
//! with the files that state it; none if leaves do not assimilate.
std::vector<StatedLeaves> stated_leaves(const Spec& spec);

//! Warns of crops with leaves that assimilate by default, which is right for C4
//! plants only.
void check_leaf_models(const Spec& spec, const Problems& problems);

//! Returns the stomata of leaves of some photosynthesis. Numbers that the table
//! lacks are those of the kind of leaf: Medlyn's slope of C4 plants, or of the
//! leaf by Farquhar, and those of maize by Ball and Berry.
Stomata to_stomata(const WaterSpec& table,
                   const Photosynthesis& photosynthesis);

//! Reports leaves whose photosynthesis does not depend on CO2, and objectives
//! that need the table [water] where it is missing.
void check_water(const Spec& spec, const Problems& problems);

}  // namespace ideotype
