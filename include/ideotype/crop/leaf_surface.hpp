// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include <glm/vec2.hpp>

#include "ideotype/core/mesh.hpp"
#include "ideotype/crop/plant.hpp"

namespace ideotype {

//! Control points along each line of a blade, a cubic B-spline.
inline constexpr std::size_t controls_along = 6;

//! One point of each of the three lines that run from base to tip.
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
//! side, and are turned about the midrib by roll + twist * (s - 1/2).
//!
//! A digitised midrib has the angles of its segments at the middles of the
//! segments, and linear interpolation between them. If a trait changes
//! insertion_angle or curvature, the change is added to these angles. The
//! surface then passes through the integral of the angle at every parameter,
//! which no six control points could follow.
class LeafSurface {
  public:
    //! Builds the leaf on a stalk along the z axis, not yet turned to its
    //! azimuth: the midrib is in the plane x = 0, y >= 0.
    //! @param distance distance of the midrib's base from the z axis [m]
    //! @throws Error if there are not six width controls.
    LeafSurface(const Leaf& leaf, const Blade& blade, double distance = 0);

    //! Returns the surface at parameter t in [0, 1] [m].
    BladeRow row(double t) const;

    //! Returns cells + 1 rows at equal parameters. They are stretched along and
    //! across so that the midrib polyline has exactly the length of the leaf,
    //! and the widest row exactly its width (measured on the blade, as on a
    //! leaf laid flat).
    //! @param begin,end relative lengths between which rows are made; the blade
    //! is moved so that its visible part begins at the stalk
    std::vector<BladeRow> tessellate(int cells, double begin = 0,
                                     double end = 1) const;

  private:
    //! Returns the midrib's angle from the vertical at relative arc length s
    //! [rad].
    double angle(double s) const;
    //! Moves a point along the midrib between two relative arc lengths, out and
    //! up: the integral of the midrib's direction by Simpson's rule [m].
    void advance(glm::dvec2& point, double begin, double stop, int steps) const;
    //! Returns the two edges of a folded blade on both sides of a midrib point.
    BladeRow across(const glm::dvec2& midrib, double angle, double width) const;

    Leaf leaf_;
    Blade blade_;
    glm::dvec3 base_;  //!< base of the midrib
    std::array<BladeRow, controls_along> controls_;
    std::vector<glm::dvec2> digitised_;  //!< relative arc length, angle [deg]
    std::array<glm::dvec2, 33> midrib_;  //!< digitised midrib in equal steps
};

//! Returns the part of a blade's length, from the tip, that contains a given
//! part of its area.
double length_from_tip(const Blade& blade, double area);

}  // namespace ideotype
