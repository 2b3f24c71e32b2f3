// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ideotype/canopy/field.hpp"
#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! Leaves cut into pieces over each of which diffuse light is taken as even.
struct Pieces {
    //! The surfaces with pieces as the first groups; the groups of all other
    //! surfaces come after them as they were.
    Mesh mesh;
    std::size_t count = 0;             //!< pieces
    std::vector<std::uint32_t> group;  //!< of the mesh that was cut, per group
    std::size_t uncut_groups = 0;  //!< uncut groups of the mesh that was cut
    //! The first of pieces that are the same part of plants that are alike.
    std::vector<std::uint32_t> like;
    //! The row that each group is in, where rows are told apart; plants of
    //! other rows are then not alike. Of objects it is of no account.
    std::vector<std::uint32_t> row{};
    std::size_t rows = 0;        //!< that are told apart
    std::vector<double> area;    //!< one-sided, of each piece [m2]
    std::vector<double> height;  //!< height of the centre of each piece [m]
};

//! Pieces of a blade, at most; a blade of very many faces has more.
inline constexpr std::size_t pieces_of_blade = 48;

//! Cuts each blade along and across: its faces are halved by area, again and
//! again, across the longer extent of their centres. Blades are faces of one
//! group that are joined by vertices at the same place.
Pieces cut_leaves(const Mesh& mesh, std::size_t per_blade = pieces_of_blade);

//! Cuts a mesh from elsewhere, whose leaves may be a few faces each. The faces
//! of blades that have fewer than those of built plants are divided first, so
//! that pieces are small against a leaf: each face into four, again and again,
//! until there are about as many as pieces of a blade, or four times as many
//! for a low tolerance. Shapes and groups stay as they are. Very large scenes
//! are divided less, or not at all.
//! @param copies of the mesh in the scene
//! @param tolerance of the light of leaves; 0: none
Pieces cut_coarse_leaves(const Mesh& mesh, std::size_t copies, double tolerance,
                         std::size_t per_blade = pieces_of_blade);

//! Returns the mean width of the blades of each group of a mesh [m]: that of a
//! rectangle of the same area and circumference. Groups that are no leaves have
//! a width of 0.
std::vector<double> blade_widths(const Mesh& mesh);

//! Returns a mesh of which nothing is cut.
Pieces uncut(const Mesh& mesh);

//! Makes the pieces of all plants of a field.
//! @param lines the pieces of one plant of each component
//! @param field drawn with the meshes of those; its mesh becomes that of the
//! result
Pieces pieces_of_field(std::span<const Pieces> lines, Field& field);

}  // namespace ideotype
