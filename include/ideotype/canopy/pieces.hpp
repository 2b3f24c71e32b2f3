// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ideotype/canopy/field.hpp"
#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! Leaves and organs that assimilate, cut into pieces; diffuse light is taken
//! as even over each piece.
struct Pieces {
    //! The surfaces, with pieces as the first groups and the unchanged groups
    //! of all other surfaces behind them.
    Mesh mesh;
    std::size_t count = 0;  //!< number of pieces
    //! Group of the uncut mesh for each group.
    std::vector<std::uint32_t> group;
    //! Number of groups of the uncut mesh that stay.
    std::size_t uncut_groups = 0;
    //! For each piece, the first piece that is the same part of a plant that is
    //! alike.
    std::vector<std::uint32_t> like;
    //! The row of each group, where rows are distinguished; plants of different
    //! rows are then not alike. The row of an object has no meaning.
    std::vector<std::uint32_t> row{};
    std::size_t rows = 0;        //!< number of distinguished rows
    std::vector<double> area;    //!< one-sided area of each piece [m2]
    std::vector<double> height;  //!< height of the centre of each piece [m]
    //! Width of the blade where each piece is, if anyone needs it [m].
    std::vector<double> width{};
};

//! The usual largest number of pieces of a blade; very fine blades have more.
inline constexpr std::size_t pieces_of_blade = 48;

//! Cuts each blade along and across: its faces are halved by area, repeatedly,
//! across the longer extent of their centres. A blade is the faces of one group
//! that are joined by vertices at the same place. Organs that assimilate are
//! cut in the same way, into pieces of four faces.
Pieces cut_leaves(const Mesh& mesh, std::size_t per_blade = pieces_of_blade);

//! Cuts a mesh of another origin; its leaves may have only a few faces each.
//! Blades with fewer faces than those of built plants are first divided, so
//! that pieces are small relative to a leaf: each face into four, repeatedly,
//! until a blade has about as many faces as pieces_of_blade, or four times as
//! many for a low tolerance. Shapes and groups stay as they are. Very large
//! scenes are divided less, or not at all.
//! @param copies number of copies of the mesh in the scene
//! @param tolerance tolerance of the light of leaves; 0: none
Pieces cut_coarse_leaves(const Mesh& mesh, std::size_t copies, double tolerance,
                         std::size_t per_blade = pieces_of_blade);

//! Returns the width of the blade where each piece is [m]: the area of a short
//! section of the blade over the length of the section.
//! @param pieces pieces of a line
std::vector<double> local_widths(const Pieces& pieces);

//! Returns the pieces of a mesh in which nothing is cut.
Pieces uncut(const Mesh& mesh);

//! Makes the pieces of all plants of a field.
//! @param lines pieces of one plant of each component
//! @param field field drawn with the meshes of the lines; its mesh is moved
//! into the result
Pieces pieces_of_field(std::span<const Pieces> lines, Field& field);

}  // namespace ideotype
