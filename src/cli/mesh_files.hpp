#pragma once

#include <string>
#include <vector>

#include "ideotype/canopy/face_light.hpp"
#include "ideotype/canopy/field.hpp"

namespace ideotype {

//! A plant or a field on its way to a file.
struct Shape {
    std::vector<std::string> about;  //!< lines for whoever reads the file
    Mesh mesh;
    std::vector<std::uint32_t> face_plant;  //!< empty: a single plant
};

//! Wavefront OBJ: a group per organ, "leaf01", and in a field per organ of a
//! plant, "plant001_leaf01".
void write_obj(const std::string& path, const Shape& shape);

//! VTK XML PolyData with cell data: what each face absorbs and its standard
//! error [MJ m-2 day-1], its area [m2], organ (leaf rank, 0 for the stalk) and
//! plant (from 1); field data: the lines about it, ground area [m2].
void write_vtp(const std::string& path, const Shape& shape,
               const FaceLight& light);

}  // namespace ideotype
