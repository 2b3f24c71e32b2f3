// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! Returns the group that a name in a mesh file stands for, as `export` names
//! groups: stalk ("stalk..."), sheath ("sheath...") or leaf (all other names),
//! each also as part of a plant of a field ("plant004_stalk..."). The number at
//! the end of the name of a leaf ("leaf07") is its rank. The component is 0.
Group group_of_name(const std::string& name);

//! Returns the number at the end of a name such as "maize_leaf07"; 0 if the
//! name does not end with "leaf" and up to four digits.
std::uint32_t leaf_rank(std::string_view name);

//! Surfaces read from a file, and warnings for the user.
struct ObjMesh {
    Mesh mesh;
    std::vector<std::string> warnings;  //!< warnings, one per kind with a count
};

//! Largest absolute coordinate that is accepted as a length in metres [m].
inline constexpr double largest_obj_coordinate = 1e6;

//! Largest number of faces; more need more memory than most computers have.
inline constexpr std::size_t most_obj_faces = 20'000'000;

//! Reads the surfaces of a Wavefront OBJ file in metres, z up.
//!
//! Polygons may have any number of corners and need be neither convex nor quite
//! plane. Faces that follow the same group (g) or object (o) name form one
//! group, wherever they are in the file; group_of_name() tells the kind of the
//! group from its name. Materials, normals and textures are ignored. Faces
//! without area are left out with a warning.
//!
//! @throws Error if the file cannot be read.
//! @throws InputError with the place of the first fault: a word that is no
//! number, a number that is not finite or too large, a corner without vertex, a
//! face of fewer than three corners; or if there are no areas or too many
//! faces.
ObjMesh read_obj(const std::string& path);

//! Reads the text of an OBJ file, as read_obj(); messages name the file.
ObjMesh parse_obj(std::string text, const std::string& file);

}  // namespace ideotype
