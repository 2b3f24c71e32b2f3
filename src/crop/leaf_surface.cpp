// SPDX-License-Identifier: Apache-2.0
#include "ideotype/crop/leaf_surface.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include "ideotype/core/error.hpp"
#include "ideotype/core/units.hpp"

namespace ideotype {

namespace {

constexpr std::size_t order = 4;  // cubic
constexpr std::array<double, controls_along + order> knots{
    0, 0, 0, 0, 1.0 / 3, 2.0 / 3, 1, 1, 1, 1};

//! Mean of the three knots inside a control point's support.
double greville(std::size_t i) {
    return (knots[i + 1] + knots[i + 2] + knots[i + 3]) / 3;
}

//! Values of all six basis functions at t (Cox-de Boor recursion; Piegl and
//! Tiller, The NURBS Book, doi:10.1007/978-3-642-59223-2, eq. 2.5).
std::array<double, controls_along> basis(double t) {
    std::array<double, knots.size() - 1> n{};
    // The last span is closed, so that t = 1 belongs to it.
    std::size_t span = order - 1;
    while (span + 1 < controls_along && t >= knots[span + 1]) ++span;
    n[span] = 1;
    for (std::size_t k = 1; k < order; ++k)
        for (std::size_t i = 0; i + k < n.size(); ++i) {
            const double rise = knots[i + k] - knots[i];
            const double fall = knots[i + k + 1] - knots[i + 1];
            n[i] = (rise > 0 ? (t - knots[i]) / rise * n[i] : 0) +
                   (fall > 0 ? (knots[i + k + 1] - t) / fall * n[i + 1] : 0);
        }
    std::array<double, controls_along> values{};
    std::copy_n(n.begin(), controls_along, values.begin());
    return values;
}

//! Control points of the cubic that passes through the points at the Greville
//! abscissae. The first and last control points are the end points.
std::array<glm::dvec2, controls_along> interpolate(
    const std::array<glm::dvec2, controls_along>& points) {
    glm::dmat4 collocation(0);  // column-major: [control][abscissa]
    glm::dvec4 right_y(0), right_z(0);
    for (int a = 0; a < 4; ++a) {
        const auto i = static_cast<std::size_t>(a) + 1;
        const auto n = basis(greville(i));
        for (int c = 0; c < 4; ++c)
            collocation[c][a] = n[static_cast<std::size_t>(c) + 1];
        const glm::dvec2 rest =
            points[i] - n.front() * points.front() - n.back() * points.back();
        right_y[a] = rest.x;
        right_z[a] = rest.y;
    }
    const glm::dmat4 solve = glm::inverse(collocation);
    const glm::dvec4 y = solve * right_y;
    const glm::dvec4 z = solve * right_z;
    return {points.front(), {y[0], z[0]}, {y[1], z[1]},
            {y[2], z[2]},   {y[3], z[3]}, points.back()};
}

}  // namespace

LeafSurface::LeafSurface(const Leaf& leaf, const Blade& blade, double distance)
    : leaf_(leaf), base_(0, distance, leaf.insertion_height) {
    if (blade.width_controls.size() != controls_along)
        throw Error("a blade needs six width controls");
    const auto angle = [&](double s) {
        return degree *
               (leaf.insertion_angle +
                leaf.curvature * std::pow(s, blade.curvature_exponent));
    };

    // The midrib as the integral of its direction, by Simpson's rule.
    std::array<glm::dvec2, controls_along> midrib;
    glm::dvec2 end{distance, leaf.insertion_height};
    double s = 0;
    midrib[0] = end;
    for (std::size_t i = 1; i < controls_along; ++i) {
        constexpr int steps = 8;
        const double h = (greville(i) - greville(i - 1)) / steps;
        for (int step = 0; step < steps; ++step, s += h) {
            const double a = angle(s), b = angle(s + h / 2), c = angle(s + h);
            end += leaf.length * h / 6 *
                   glm::dvec2(std::sin(a) + 4 * std::sin(b) + std::sin(c),
                              std::cos(a) + 4 * std::cos(b) + std::cos(c));
        }
        s = greville(i);
        midrib[i] = end;
    }
    const auto midrib_controls = interpolate(midrib);

    const double rise = blade.folding_angle * degree;
    for (std::size_t i = 0; i < controls_along; ++i) {
        const double a = angle(greville(i));
        const glm::dvec3 upper(0, -std::cos(a), std::sin(a));
        const double half = leaf.width / 2 * blade.width_controls[i];
        const glm::dvec3 foot(0, midrib_controls[i].x, midrib_controls[i].y);
        const glm::dvec3 across(half * std::cos(rise), 0, 0);
        const glm::dvec3 up = half * std::sin(rise) * upper;
        controls_[i] = {foot - across + up, foot, foot + across + up};
    }
}

BladeRow LeafSurface::row(double t) const {
    const auto n = basis(t);
    glm::dvec3 left(0), midrib(0), right(0);
    for (std::size_t i = 0; i < controls_along; ++i) {
        left += n[i] * controls_[i].left;
        midrib += n[i] * controls_[i].midrib;
        right += n[i] * controls_[i].right;
    }
    return {left, midrib, right};
}

std::vector<BladeRow> LeafSurface::tessellate(int cells) const {
    std::vector<BladeRow> rows;
    double length = 0;
    double width = 0;
    for (int i = 0; i <= cells; ++i) {
        rows.push_back(row(static_cast<double>(i) / cells));
        const glm::dvec3 midrib = rows.back().midrib;
        if (i > 0) length += glm::distance(midrib, rows.end()[-2].midrib);
        width = std::max(width, glm::distance(midrib, rows.back().left) +
                                    glm::distance(midrib, rows.back().right));
    }
    const double along = leaf_.length / length;
    const double across = leaf_.width / width;
    for (BladeRow& r : rows) {
        const glm::dvec3 midrib = r.midrib;
        const glm::dvec3 moved = base_ + along * (midrib - base_);
        r.left = moved + across * (r.left - midrib);
        r.right = moved + across * (r.right - midrib);
        r.midrib = moved;
    }
    return rows;
}

}  // namespace ideotype
