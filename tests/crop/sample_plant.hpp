// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/crop/plant.hpp"

namespace ideotype {

//! Three unlike leaves on a pole that is taller than they are.
inline Plant sample_plant() {
    Plant plant;
    plant.name = "sample";
    plant.leaves = {{0.651, 0.073, 34, 90, 90, 0.1},
                    {0.822, 0.085, 24.5, 40, 270, 0.9},
                    {0.484, 0.0545, 80, 0, 15, 1.6}};
    plant.blade.width_controls = {0.28,     0.885870, 0.895017,
                                  1.149943, 0.379696, 0.0};
    plant.stalk = {{}, true, 2.0, 0.027};
    return plant;
}

}  // namespace ideotype
