// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/canopy/request.hpp"

namespace ideotype {

//! Plants of two leaves on a clear day at Ames.
inline CanopyRequest two_leaves(const Accuracy& accuracy) {
    Plant plant;
    plant.leaves = {{.7, .08, 40, 60, 90, .2}, {.5, .06, 30, 40, 270, .5}};
    plant.blade.width_controls = {.28, .89, .9, 1.15, .38, 0};
    plant.stalk = {true, 2, .027, 0, LeafBase::axis};
    Scenario ames;
    ames.field = {2, 2, {.76, .15, 90}};
    ames.light = illuminate(
        clear_days({"ames", 42, -93.6, -5}, {{{2025, 8, 7}}, 7, 20, 60}, .45),
        SkyModel::uniform, ames.field.spacing.row_direction);
    ames.optics = {{.05, .05}, {.31, .12}, .1};
    return {plant, ames, {.25, 4}, accuracy, {1}, {}};
}

}  // namespace ideotype
