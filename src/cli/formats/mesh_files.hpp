// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/core/estimate.hpp"
#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! A plant or a field to be written to a file.
struct Shape {
    std::vector<std::string> about;  //!< comment lines of the file
    Mesh mesh;
    std::vector<std::uint32_t> face_plant;  //!< empty for a single plant
    //! Ground area of the shape [m2]. The sum of absorbed light times area over
    //! all faces, divided by this area, is absorbed light per ground area.
    double ground_area = 0;
};

//! Writes a Wavefront OBJ file with one group per organ: "leaf01", or
//! "plant001_leaf01" in a field. Objects keep their names.
void write_obj(const std::string& path, const Shape& shape);

//! Writes VTK XML PolyData with cell data: light absorbed by each face per
//! one-sided area and its standard error [MJ m-2 day-1], area [m2], organ (leaf
//! rank, 0 for the stalk) and plant (from 1). Field data: comment lines and
//! ground area [m2].
//! @param light light absorbed by each face [J m-2 day-1]
void write_vtp(const std::string& path, const Shape& shape,
               const std::vector<Estimate>& light);

}  // namespace ideotype
