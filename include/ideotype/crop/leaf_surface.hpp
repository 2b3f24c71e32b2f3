// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "ideotype/core/mesh.hpp"
#include "ideotype/crop/plant.hpp"

namespace ideotype {

//! Control points of a blade per row: a cubic B-spline has six.
inline constexpr std::size_t controls_along = 6;

//! One point of each line that runs from base to tip.
struct BladeRow {
    glm::dvec3 left;
    glm::dvec3 midrib;
    glm::dvec3 right;
};

//! The blade of one leaf as a NURBS surface of 3 x 6 control points with unit
//! weights: linear across (left edge, midrib, right edge), cubic along, knots
//! at 1/3 and 2/3.
//!
//! The midrib lies in a vertical plane. Its angle from the vertical at
//! relative arc length s is insertion_angle + curvature * s^curvature_exponent.
//! Its six control points make the spline pass through that curve at the
//! Greville abscissae, so that the spline parameter is close to relative arc
//! length. The halves of the blade rise by `folding_angle` towards the upper
//! side.
class LeafSurface {
  public:
    //! The leaf grows from a stalk on the z axis, before it is turned to its
    //! azimuth: the midrib is in the plane x = 0, y >= 0.
    //! @param distance of the midrib's base from the z axis [m]
    //! @throws Error if there are not six width controls.
    LeafSurface(const Leaf& leaf, const Blade& blade, double distance = 0);

    //! The surface at parameter t in [0, 1] [m].
    BladeRow row(double t) const;

    //! cells + 1 rows at equal parameters, stretched along and across by the
    //! little that makes the length of the midrib polyline exactly the leaf's
    //! length and the widest row exactly its width (measured on the blade, as
    //! on a leaf laid flat).
    std::vector<BladeRow> tessellate(int cells) const;

  private:
    Leaf leaf_;
    glm::dvec3 base_;  //!< of the midrib
    std::array<BladeRow, controls_along> controls_;
};

}  // namespace ideotype
