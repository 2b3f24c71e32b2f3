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
    //! Plant of each face; empty for a single plant.
    std::vector<std::uint32_t> face_plant;
    //! Ground area of the shape [m2]. To get the absorbed light per ground
    //! area, sum light times area over all faces and divide by it.
    double ground_area = 0;
};

//! Writes a Wavefront OBJ file with one group per organ, such as "leaf01", or
//! "plant001_leaf01" in a field. Groups of objects keep their names.
void write_obj(const std::string& path, const Shape& shape);

//! Writes a VTK XML PolyData file. Cell data are the light absorbed by each
//! face per one-sided area with its standard error [MJ m-2 day-1], the area
//! [m2], the organ (leaf rank, 0 for the stalk) and the plant (from 1). Field
//! data are comment lines and the ground area [m2].
//! @param light light absorbed by each face [J m-2 day-1]
void write_vtp(const std::string& path, const Shape& shape,
               const std::vector<Estimate>& light);

}  // namespace ideotype
