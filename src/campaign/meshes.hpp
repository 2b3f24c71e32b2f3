// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "entries.hpp"
#include "ideotype/canopy/scene.hpp"
#include "ideotype/core/mesh.hpp"
#include "ideotype/core/range.hpp"
#include "spec/problems.hpp"

namespace ideotype {

//! Makes the mesh of an object at its position in the field.
Mesh mesh_of(const ObjectEntry& object);

//! Makes a mesh from the content of a file. Groups with names such as "leaf07"
//! are leaves; if there are no such names, all groups are leaves.
Mesh mesh_of(const MeshContent& content);

//! Numbers the leaves of a mesh by group name. Groups with names such as
//! "leaf07" are leaves; if there are no such names, all groups are leaves.
void number_groups(Mesh& mesh);

//! Returns the index of the first entry that contains a prefix of a name, or
//! the number of entries if there is none.
template <class Entry>
std::size_t first_that_fits(const std::vector<Entry>& entries,
                            const std::string& name) {
    const auto fits = [&](const Entry& entry) {
        return std::ranges::any_of(entry.groups, [&](const auto& prefix) {
            return name.starts_with(prefix);
        });
    };
    return static_cast<std::size_t>(std::ranges::find_if(entries, fits) -
                                    entries.begin());
}

//! Makes a mesh part of a scene: assigns to each group the first material that
//! matches its name, and appends the materials to the wavebands of the scene.
//! @param materials materials that have values in all these wavebands
void add_surfaces(const std::vector<MaterialSpec>& materials, Mesh& mesh,
                  Bands& bands);

//! Makes a mesh of a single material part of a scene.
void add_surfaces(const ByBand<Lambertian>& optics, Mesh& mesh, Bands& bands);

//! A smaller depth below the soil is attributed to rounding [m].
inline constexpr double least_depth = 1e-3;

//! Returns the lowest and the highest vertex of all faces [m].
Range heights_of(const Mesh& mesh);

//! Returns the reason why light in copies of a mesh cannot be traced in bounded
//! time: the mesh is too large relative to the periodic cell. Returns nothing
//! if light can be traced.
//! @param copies number of copies of the mesh in the cell
//! @return text that follows the name of the mesh
std::optional<std::string> excess_of(const Mesh& mesh, double copies,
                                     const Cell& cell);

//! Reads the OBJ file that a key names, unless it has already been read.
//! @param folder file to which the path of the OBJ file is relative
void read_content(MeshContent& content, const std::string& key,
                  const std::string& folder, const Problems& problems);

//! Returns whether all indices of vertices and groups are valid.
bool is_whole(const MeshContent& content);

}  // namespace ideotype
