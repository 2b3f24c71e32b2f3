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
//! @param table checked table
Photosynthesis to_photosynthesis(const PhotosynthesisSpec& table);

//! Returns the photosynthesis parameters of each component, the main crop
//! first, with the files that state them; empty if leaves do not assimilate.
std::vector<StatedLeaves> stated_leaves(const Spec& spec);

//! Warns about crops that use the default photosynthesis, which suits C4 plants
//! only.
void check_leaf_models(const Spec& spec, const Problems& problems);

//! Returns the stomatal parameters of leaves. Parameters missing in the table
//! depend on the leaf: for Medlyn the slope of C4 plants or of the Farquhar
//! leaf, for Ball and Berry those of maize.
Stomata to_stomata(const WaterSpec& table,
                   const Photosynthesis& photosynthesis);

//! Reports leaves with photosynthesis that does not respond to CO2, if [water]
//! requires such a response.
void check_water(const Spec& spec, const Problems& problems);

}  // namespace ideotype
