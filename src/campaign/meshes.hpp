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

//! Returns the surfaces of an object at its place in the field.
Mesh mesh_of(const ObjectEntry& object);

//! Returns the mesh of each plant of a component. Its groups have the number of
//! their material; those of names such as "leaf07" are leaves, or all groups if
//! there are none.
Mesh mesh_of(const ComponentMesh& described);

//! Numbers the groups of a mesh by their names: those such as "leaf07" are
//! leaves, or all groups if there are none.
void number_groups(Mesh& mesh);

//! Returns the place of the first entry with a text that a name begins with, or
//! the number of entries.
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

//! Returns the material of [reflectance, transmittance], or of [reflectance of
//! the upper face, of the lower face, transmittance].
Material material_of(const std::vector<double>& parts);

//! Returns the materials of the mesh in each waveband.
ByBand<std::vector<Material>> materials_of(const ComponentMesh& described);

//! The depth below the soil that rounding may explain [m].
inline constexpr double least_depth = 1e-3;

//! Returns the lowest and the highest corner of all faces [m].
Range heights_of(const Mesh& mesh);

//! Returns why light in copies of a mesh could not be traced in a bounded time:
//! the size of the mesh relative to the cell with which it repeats. Returns
//! nothing if it can be traced.
//! @param copies copies of the mesh in the cell
//! @return words that follow the name of the mesh
std::optional<std::string> excess_of(const Mesh& mesh, double copies,
                                     const Cell& cell);

//! Reads the OBJ file that a key names; nothing if its problems are reported.
std::optional<Mesh> read_mesh(const std::string& path, const std::string& key,
                              const Problems& problems);

//! Appends coordinates of vertices and vertex numbers of faces to lists.
void take_surfaces(const Mesh& mesh, std::vector<double>& vertices,
                   std::vector<double>& faces);

}  // namespace ideotype
