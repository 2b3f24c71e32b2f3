// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/core/estimate.hpp"
#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! A plant or a field on its way to a file.
struct Shape {
    std::vector<std::string> about;  //!< lines for readers of the file
    Mesh mesh;
    std::vector<std::uint32_t> face_plant;  //!< empty for a single plant
    //! The ground area of the shape [m2]. Absorbed light times area, summed
    //! over all faces, over this area is the light that plants absorb per
    //! ground area.
    double ground_area = 0;
};

//! Writes a Wavefront OBJ file with a group per organ, "leaf01", in a field per
//! organ of a plant, "plant001_leaf01", and objects by their names.
void write_obj(const std::string& path, const Shape& shape);

//! Writes VTK XML PolyData with cell data: the light that a face absorbs per
//! one-sided area (given in J m-2 day-1) and the standard error [MJ m-2 day-1],
//! area [m2], organ (leaf rank, 0 for the stalk) and plant (from 1); field
//! data: lines for readers, ground area [m2].
void write_vtp(const std::string& path, const Shape& shape,
               const std::vector<Estimate>& light);

}  // namespace ideotype
