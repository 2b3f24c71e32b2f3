// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! Parses the name of a group in a mesh file, as `export` writes it: stalk
//! ("stalk..."), sheath ("sheath...") or leaf (all other names), optionally
//! prefixed by a plant number ("plant004_stalk..."). The number at the end of a
//! leaf's name ("leaf07") is its rank. The component is set to 0.
Group parse_group_name(const std::string& name);

//! Returns the number at the end of a name such as "maize_leaf07"; 0 if the
//! name does not end with "leaf" and up to four digits.
std::uint32_t leaf_rank(std::string_view name);

//! Surfaces read from a file, and warnings for the user.
struct ObjMesh {
    Mesh mesh;
    std::vector<std::string> warnings;  //!< warnings, one per kind with a count
};

//! Largest coordinate, in absolute value, that is accepted as metres [m].
inline constexpr double largest_obj_coordinate = 1e6;

//! Largest number of faces that is accepted; more would exceed the memory of
//! most computers.
inline constexpr std::size_t most_obj_faces = 20'000'000;

//! Reads the surfaces of a Wavefront OBJ file in metres, z up.
//!
//! Polygons may have any number of corners and need be neither convex nor
//! exactly planar. Faces with the same group (g) or object (o) name form one
//! group, wherever they are in the file; parse_group_name() derives the
//! material from this name. Materials, normals and textures are ignored. Faces
//! without area are omitted with a warning.
//!
//! @throws Error if the file cannot be read.
//! @throws InputError with the location of the first error: a word that is not
//! a number, a number that is infinite or too large, a corner without a vertex,
//! or a face with fewer than three corners. Also if the total area is zero or
//! there are too many faces.
ObjMesh read_obj(const std::string& path);

//! Parses the text of an OBJ file like read_obj(); messages contain the file
//! name.
ObjMesh parse_obj(std::string text, const std::string& file);

}  // namespace ideotype
