// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ideotype/canopy/field.hpp"
#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! Assimilating leaves and organs, cut into pieces over which diffuse light is
//! taken as uniform.
struct Pieces {
    //! The surfaces. Pieces are the first groups; the groups of all other
    //! surfaces follow unchanged.
    Mesh mesh;
    std::size_t count = 0;  //!< number of pieces
    //! Group of the uncut mesh for each group.
    std::vector<std::uint32_t> group;
    //! Number of groups of the uncut mesh that are not cut into pieces.
    std::size_t uncut_groups = 0;
    //! For each piece, the first piece that is the same part of an identical
    //! plant.
    std::vector<std::uint32_t> like;
    //! The row of each group, where rows are distinguished. Plants in different
    //! rows then count as different. The row of an object is undefined.
    std::vector<std::uint32_t> row{};
    std::size_t rows = 0;        //!< number of distinguished rows
    std::vector<double> area;    //!< one-sided area of each piece [m2]
    std::vector<double> height;  //!< height of the centre of each piece [m]
    //! Width of the blade at each piece, if needed [m].
    std::vector<double> width{};
};

//! The usual maximum number of pieces per blade; very fine blades have more.
inline constexpr std::size_t pieces_of_blade = 48;

//! Cuts each blade along and across: its faces are halved by area, repeatedly,
//! across the longer extent of their centres. A blade is the set of faces of
//! one group that are connected by coincident vertices. Assimilating organs are
//! cut in the same way, into pieces of four faces.
Pieces cut_leaves(const Mesh& mesh, std::size_t per_blade = pieces_of_blade);

//! Cuts a mesh that was not built by this program and may have only a few faces
//! per leaf. Blades with fewer faces than those of built plants are first
//! subdivided, so that pieces are small relative to a leaf. Each face is
//! divided into four, repeatedly, until a blade has about as many faces as
//! pieces_of_blade, or four times as many for a low tolerance. Shapes and
//! groups do not change. Very large scenes are subdivided less, or not at all.
//! @param copies number of copies of the mesh in the scene
//! @param tolerance tolerance of the light of leaves; 0: none
Pieces cut_coarse_leaves(const Mesh& mesh, std::size_t copies, double tolerance,
                         std::size_t per_blade = pieces_of_blade);

//! Returns the width of the blade at each piece [m]: the area of a short
//! section of the blade divided by its length.
//! @param pieces pieces of a line
std::vector<double> local_widths(const Pieces& pieces);

//! Wraps a mesh without cutting it.
Pieces uncut(const Mesh& mesh);

//! Makes the pieces of all plants in a field.
//! @param lines pieces of one plant of each component
//! @param field field generated from the meshes of the lines; its mesh is moved
//! into the result
Pieces pieces_of_field(std::span<const Pieces> lines, Field& field);

}  // namespace ideotype
