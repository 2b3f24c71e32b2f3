// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "ideotype/light/ray_scene.hpp"

namespace ideotype {

//! Returns an order of points of a scene in which neighbours are near each
//! other, by blocks of the cell or the plot.
template <class PositionOf>
std::vector<std::uint32_t> order_by_place(const RayScene& scene,
                                          std::size_t count,
                                          const PositionOf& position_of);

//! The blocks of a scene in Morton's order: near blocks have near numbers.
class Blocks {
  public:
    //! Divides a scene into a few blocks per point.
    Blocks(const RayScene& scene, std::size_t points);

    std::uint32_t at(const glm::dvec3& position) const;
    std::size_t count() const { return std::size_t{1} << (3 * bits_); }

  private:
    const RayScene& scene_;
    unsigned bits_ = 1;  //!< bits of each coordinate's number
    glm::dvec3 per_metre_;
};

template <class PositionOf>
std::vector<std::uint32_t> order_by_place(const RayScene& scene,
                                          std::size_t count,
                                          const PositionOf& position_of) {
    const Blocks blocks(scene, count);
    std::vector<std::uint32_t> of, ends(blocks.count() + 1);
    of.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        of.push_back(blocks.at(position_of(i)));
        ++ends[of.back() + 1];
    }
    for (std::size_t b = 1; b < ends.size(); ++b) ends[b] += ends[b - 1];
    std::vector<std::uint32_t> order(count);
    for (std::uint32_t i = 0; i < count; ++i) order[ends[of[i]]++] = i;
    return order;
}

}  // namespace ideotype
