// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! Leaves cut into pieces over each of which diffuse light is taken as even.
struct Pieces {
    //! The surfaces with pieces as the groups of leaves; other groups come
    //! after them as they were.
    Mesh mesh;
    std::size_t count = 0;             //!< pieces
    std::vector<std::uint32_t> group;  //!< of the mesh that was cut, per group
    //! The first of pieces that are the same part of plants that are alike.
    std::vector<std::uint32_t> like;
    std::vector<double> area;    //!< one-sided, of each piece [m2]
    std::vector<double> height;  //!< of the centre of each piece [m]
};

//! Pieces of a blade, at most; a blade of very many faces has more.
inline constexpr std::size_t pieces_of_blade = 48;

//! Cuts each blade along and across: its faces are halved by area, again and
//! again, across the longer extent of their centres. Blades are faces of one
//! group that are joined by vertices at the same place.
//! @param whole kept apart even where they touch: one number per face, such as
//! the plant that it is of; empty: nothing is
Pieces cut_leaves(const Mesh& mesh,
                  const std::vector<std::uint32_t>& whole = {},
                  std::size_t per_blade = pieces_of_blade);

//! The pieces of each plant of a field of plants that were cut.
Pieces pieces_of_field(const Pieces& plant, Mesh field,
                       const std::vector<std::uint32_t>& face_plant);

}  // namespace ideotype
