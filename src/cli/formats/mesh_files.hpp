// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/core/estimate.hpp"
#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! A plant or a field on its way to a file.
struct Shape {
    std::vector<std::string> about;  //!< lines for whoever reads the file
    Mesh mesh;
    std::vector<std::uint32_t> face_plant;  //!< empty: a single plant
    //! That its faces draw their light from [m2]: absorbed light times area,
    //! summed over all faces, over this is what leaves and stalks absorb for
    //! each area of ground.
    double ground_area = 0;
};

//! Wavefront OBJ: a group per organ, "leaf01", and in a field per organ of a
//! plant, "plant001_leaf01", and objects by their names.
void write_obj(const std::string& path, const Shape& shape);

//! VTK XML PolyData with cell data: what each face absorbs for its one-sided
//! area (given in J m-2 day-1) and its standard error [MJ m-2 day-1], its area
//! [m2], organ (leaf rank, 0 for the stalk) and plant (from 1); field data: the
//! lines about it, ground area [m2].
void write_vtp(const std::string& path, const Shape& shape,
               const std::vector<Estimate>& light);

}  // namespace ideotype
