// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include <glm/vec2.hpp>

#include "ideotype/core/mesh.hpp"
#include "ideotype/crop/plant.hpp"

namespace ideotype {

//! Control points along each line of a blade; each line is a cubic B-spline.
inline constexpr std::size_t controls_along = 6;

//! One point of each of the three lines that run from base to tip.
struct BladeRow {
    glm::dvec3 left;
    glm::dvec3 midrib;
    glm::dvec3 right;
};

//! The blade of one leaf as a NURBS surface of 3 x 6 control points with unit
//! weights. It is linear across (left edge, midrib, right edge) and cubic along
//! the blade, with knots at 1/3 and 2/3.
//!
//! The midrib lies in a vertical plane. Its angle from the vertical at relative
//! arc length s is insertion_angle + curvature * s^curvature_exponent. Six
//! control points make the spline interpolate that curve at the Greville
//! abscissae, so that the spline parameter is close to relative arc length.
//! Both halves of the blade rise by `folding_angle` towards the upper side, and
//! are rotated about the midrib by roll + twist * (s - 1/2).
//!
//! For a digitised midrib, the angle of each segment applies at the middle of
//! the segment, with linear interpolation in between. If a trait changes
//! insertion_angle or curvature, the change is added to these angles. The
//! midrib is then the integral of its direction at every parameter, because six
//! control points could not follow it.
class LeafSurface {
  public:
    //! Builds the leaf on a stalk along the z axis, before rotation to its
    //! azimuth: the midrib is in the plane x = 0, y >= 0.
    //! @param distance distance of the midrib's base from the z axis [m]
    //! @throws Error if there are not six width controls.
    LeafSurface(const Leaf& leaf, const Blade& blade, double distance = 0);

    //! Returns the three points of the surface at parameter t in [0, 1] [m].
    BladeRow row(double t) const;

    //! Returns cells + 1 rows at equal parameters. The rows are stretched along
    //! and across so that the midrib polyline has exactly the leaf's length and
    //! the widest row exactly its width, as measured on a leaf laid flat.
    //! @param begin,end relative lengths between which rows are made; the blade
    //! is shifted so that this part begins at the stalk
    std::vector<BladeRow> tessellate(int cells, double begin = 0,
                                     double end = 1) const;

  private:
    //! Returns the midrib's angle from the vertical at relative arc length s
    //! [rad].
    double angle(double s) const;
    //! Moves a point (distance from the stalk, height) [m] along the midrib
    //! from one relative arc length to another, by integrating the direction of
    //! the midrib with Simpson's rule.
    void advance(glm::dvec2& point, double begin, double stop, int steps) const;
    //! Returns a midrib point with the edges of the folded blade on both sides.
    BladeRow across(const glm::dvec2& midrib, double angle, double width) const;

    Leaf leaf_;
    Blade blade_;
    glm::dvec3 base_;  //!< base of the midrib
    std::array<BladeRow, controls_along> controls_;
    std::vector<glm::dvec2> digitised_;  //!< relative arc length, angle [deg]
    //! Digitised midrib at equal parameter steps.
    std::array<glm::dvec2, 33> midrib_;
};

//! Returns the fraction of a blade's length, measured from the tip, that
//! contains a given fraction of the blade's area.
double length_from_tip(const Blade& blade, double area);

}  // namespace ideotype
