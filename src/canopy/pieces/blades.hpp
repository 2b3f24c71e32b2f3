// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! Indices of faces of a mesh.
using Faces = std::vector<std::uint32_t>;

//! Disjoint sets of indices (union-find).
class Joined {
  public:
    explicit Joined(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }

    std::uint32_t first(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    void join(std::uint32_t a, std::uint32_t b) {
        a = first(a);
        b = first(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> parent_;
};

//! Returns whether a face belongs to a surface that is cut into pieces: a leaf
//! or an assimilating organ.
inline bool is_cut(const Mesh& mesh, std::uint32_t face) {
    return mesh.groups[mesh.face_group[face]].assimilates();
}

//! Joins faces of surfaces that are cut into pieces, if they share coincident
//! vertices.
//! @param part part number of each group; only faces with equal numbers are
//! joined
Joined joined_faces(const Mesh& mesh, const Faces& part);

//! Returns the faces of each blade, and of each connected part of other organs
//! that are cut, in the order of groups and first faces.
std::vector<Faces> blades(const Mesh& mesh);

}  // namespace ideotype
