// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "campaign/campaign.hpp"
#include "ideotype/canopy/scene.hpp"

namespace ideotype {

//! Returns whether any panels track the sun, so that each instant needs a sky
//! of its own.
bool has_trackers(const Campaign& campaign);

//! Adds the panels and objects of a campaign to a scene that already has its
//! components, cell and bands.
void add_objects(Scene& scene, const Campaign& campaign,
                 const Spacing& spacing);

}  // namespace ideotype
