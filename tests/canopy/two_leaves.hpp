// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/canopy/field.hpp"
#include "ideotype/canopy/request.hpp"

namespace ideotype {

//! Returns plants of two leaves on a clear day at Ames.
//! @param erect the angle by which leaves are steeper and bend less [deg]
inline CanopyRequest two_leaves(const Accuracy& accuracy, double erect = 0) {
    Plant plant;
    plant.leaves = {{.7, .08, 40 - erect, 60 - erect, 90, .2},
                    {.5, .06, 30 - erect, 40 - erect, 270, .5}};
    plant.blade.width_controls = {.28, .89, .9, 1.15, .38, 0};
    plant.stalk = {{}, true, 2, .027};
    const FieldForm form{2, 2, {.76, .15, 90}};
    Scene ames;
    ames.components = {component_of(plant, form)};
    ames.cell = cell_of(form);
    ames.bands = {{"par",
                   illuminate(clear_days({"ames", 42, -93.6, -5},
                                         {{{2025, 8, 7}}, 7, 20, 60}, .45),
                              SkyModel::uniform, form.spacing.row_direction),
                   {PlantOptics{{.05, .05}, {.31, .12}, {}}.materials(), .1}}};
    return {std::move(ames), {.25, 4}, accuracy, {1}};
}

}  // namespace ideotype
