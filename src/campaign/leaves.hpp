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

//! Makes the photosynthesis model that a table describes.
//! @param table table that has been checked
Photosynthesis to_photosynthesis(const PhotosynthesisSpec& table);

//! Returns the photosynthesis parameters of each component, the main crop
//! first, with the files that state them. The result is empty if assimilation
//! is not computed.
std::vector<StatedLeaves> stated_leaves(const Spec& spec);

//! Warns if crops use the default photosynthesis, which is suitable only for C4
//! plants.
void check_leaf_models(const Spec& spec, const Problems& problems);

//! Returns the stomatal parameters of leaves. Defaults depend on the leaf
//! model. For the model of Medlyn, the default slope is that of C4 plants or,
//! for Farquhar leaves, their parameter g1. For the model of Ball and Berry,
//! defaults are those of maize.
Stomata to_stomata(const WaterSpec& table,
                   const Photosynthesis& photosynthesis);

//! Reports prices of what the campaign does not compute.
void check_prices(const Spec& spec, const Problems& problems);

//! Reports what soil that dries requires, and contradictions of [soil] and
//! [irrigation].
void check_soil(const Spec& spec, const Problems& problems);

//! Reports leaf models that do not respond to CO2, if [water] requires a
//! response.
void check_water(const Spec& spec, const Problems& problems);

}  // namespace ideotype
