#pragma once

#include <string>
#include <vector>

#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! Surfaces read from a file, and what the user should know about them.
struct ObjMesh {
    Mesh mesh;
    std::vector<std::string> warnings;  //!< counted, one kind each
};

//! Largest coordinate that is taken for one in metres [m].
inline constexpr double largest_obj_coordinate = 1e6;

//! Reads the surfaces of a Wavefront OBJ file in metres, z up.
//!
//! Polygons may have any number of corners and need be neither convex nor
//! quite plane. Faces that follow the same group (g) or object (o) name are
//! one group, wherever they are in the file; all are leaves. Materials,
//! normals and textures are ignored. Faces without area are left out with a
//! warning.
//!
//! @throws Error if the file cannot be read.
//! @throws InputError with the place of the first thing wrong: what is not a
//! number, not finite or too large, a corner that is no vertex, a face of
//! fewer than three corners; or if no face has an area.
ObjMesh read_obj(const std::string& path);

//! As read_obj, from text; file is used in messages.
ObjMesh parse_obj(const std::string& text, const std::string& file);

}  // namespace ideotype
