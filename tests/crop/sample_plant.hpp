// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/crop/plant.hpp"

namespace ideotype {

//! Makes a plant with three different leaves and a stalk that rises above them.
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

//! Returns the total area of the faces of a group [m2].
inline double group_area(const Mesh& mesh, const std::string& group) {
    const std::vector<double> areas = face_areas(mesh);
    double sum = 0;
    for (std::size_t f = 0; f < areas.size(); ++f)
        if (mesh.groups[mesh.face_group[f]].name == group) sum += areas[f];
    return sum;
}

}  // namespace ideotype
