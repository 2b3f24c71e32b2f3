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

constexpr std::size_t order = 4;  // order of a cubic spline
constexpr std::array<double, controls_along + order> knots{
    0, 0, 0, 0, 1.0 / 3, 2.0 / 3, 1, 1, 1, 1};

//! Returns the mean of the three knots inside a control point's support.
double greville(std::size_t i) {
    return (knots[i + 1] + knots[i + 2] + knots[i + 3]) / 3;
}

//! Returns the values of all six basis functions at t (Cox-de Boor recursion;
//! Piegl and Tiller, The NURBS Book, doi:10.1007/978-3-642-59223-2, eq. 2.5).
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

//! Returns the control points of the cubic curve that passes through the given
//! points at the Greville abscissae. The first and last control points are the
//! ends of the curve.
std::array<glm::dvec2, controls_along> interpolate(
    const std::array<glm::dvec2, controls_along>& points) {
    glm::dmat4 collocation(0);  // column-major matrix: [control][abscissa]
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

//! For each segment of a digitised midrib, returns the relative arc length at
//! its middle and its angle from the vertical [deg]. Angles are unwrapped: they
//! exceed 180 where the midrib curls, and never jump by more than 180.
std::vector<glm::dvec2> measure_angles(const std::vector<glm::dvec2>& points) {
    std::vector<glm::dvec2> angles;
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const glm::dvec2 step = points[i] - points[i - 1];
        const double size = glm::length(step);
        if (size == 0) continue;
        double angle = std::atan2(step.x, step.y) / degree;
        if (!angles.empty())
            angle += 360 * std::round((angles.back().y - angle) / 360);
        angles.emplace_back(length + size / 2, angle);
        length += size;
    }
    for (glm::dvec2& segment : angles) segment.x /= length;
    return angles;
}

//! Returns a vector turned about an axis of unit length (Rodrigues' formula).
glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& axis, double angle) {
    const double sine = std::sin(angle), cosine = std::cos(angle);
    return cosine * v + sine * glm::cross(axis, v) +
           (1 - cosine) * glm::dot(axis, v) * axis;
}

}  // namespace

bool measure_midrib(Leaf& leaf) {
    const std::vector<glm::dvec2> angles = measure_angles(leaf.midrib);
    if (angles.empty()) return false;
    leaf.insertion_angle = angles.front().y;
    leaf.curvature = angles.back().y - angles.front().y;
    return true;
}

double LeafSurface::angle(double s) const {
    const double bend = std::pow(s, blade_.curvature_exponent);
    if (digitised_.empty())
        return degree * (leaf_.insertion_angle + leaf_.curvature * bend);
    // Interpolate the angles of segments, and add the changes that traits
    // cause.
    const glm::dvec2 first = digitised_.front(), last = digitised_.back();
    const auto next =
        std::find_if(digitised_.begin(), digitised_.end(),
                     [&](const auto& segment) { return segment.x > s; });
    double angle = next == digitised_.begin() ? first.y : last.y;
    if (next != digitised_.begin() && next != digitised_.end())
        angle = glm::mix(next[-1].y, next->y,
                         (s - next[-1].x) / (next->x - next[-1].x));
    return degree * (angle + leaf_.insertion_angle - first.y +
                     (leaf_.curvature - (last.y - first.y)) * bend);
}

void LeafSurface::advance(glm::dvec2& point, double begin, double stop,
                          int steps) const {
    const double h = (stop - begin) / steps;
    const auto along = [&](double s) {
        const double a = angle(s);
        return glm::dvec2(std::sin(a), std::cos(a));
    };
    double s = begin;
    glm::dvec2 last = along(s);
    for (int step = 0; step < steps; ++step, s += h) {
        const glm::dvec2 middle = along(s + h / 2), next = along(s + h);
        point += leaf_.length * h / 6 * (last + 4. * middle + next);
        last = next;
    }
}

LeafSurface::LeafSurface(const Leaf& leaf, const Blade& blade, double distance)
    : leaf_(leaf), blade_(blade), base_(0, distance, leaf.insertion_height) {
    if (blade.width_controls.size() != controls_along)
        throw Error("a blade has other than six width controls; give six");
    glm::dvec2 end{distance, leaf.insertion_height};
    // A digitised midrib is tabulated in equal steps of arc length.
    if (!leaf.midrib.empty()) {
        digitised_ = measure_angles(leaf.midrib);
        if (digitised_.empty())
            throw Error(
                "a midrib has no two points that differ; give points from the "
                "base to the tip");
        for (std::size_t i = 0; i < midrib_.size(); ++i) {
            midrib_[i] = end;
            const auto steps = static_cast<double>(midrib_.size() - 1);
            const auto step = static_cast<double>(i);
            advance(end, step / steps, (step + 1) / steps, 2);
        }
        return;
    }
    // Otherwise define the midrib by six control points that follow the given
    // angles.
    std::array<glm::dvec2, controls_along> midrib;
    midrib[0] = end;
    for (std::size_t i = 1; i < controls_along; ++i) {
        advance(end, greville(i - 1), greville(i), 8);
        midrib[i] = end;
    }
    const auto midrib_controls = interpolate(midrib);
    for (std::size_t i = 0; i < controls_along; ++i)
        controls_[i] = across(midrib_controls[i], angle(greville(i)),
                              blade.width_controls[i]);
}

BladeRow LeafSurface::across(const glm::dvec2& midrib, double angle,
                             double width) const {
    const double rise = blade_.folding_angle * degree;
    const glm::dvec3 upper(0, -std::cos(angle), std::sin(angle));
    const double half = leaf_.width / 2 * width;
    const glm::dvec3 foot(0, midrib.x, midrib.y);
    const glm::dvec3 side(half * std::cos(rise), 0, 0);
    const glm::dvec3 up = half * std::sin(rise) * upper;
    return {foot - side + up, foot, foot + side + up};
}

BladeRow LeafSurface::row(double t) const {
    const auto n = basis(t);
    BladeRow row{};
    if (digitised_.empty()) {
        for (std::size_t i = 0; i < controls_along; ++i) {
            row.left += n[i] * controls_[i].left;
            row.midrib += n[i] * controls_[i].midrib;
            row.right += n[i] * controls_[i].right;
        }
    } else {
        double width = 0;
        for (std::size_t i = 0; i < controls_along; ++i)
            width += n[i] * blade_.width_controls[i];
        const double position = t * static_cast<double>(midrib_.size() - 1);
        const auto i =
            std::min(static_cast<std::size_t>(position), midrib_.size() - 2);
        row = across(glm::mix(midrib_[i], midrib_[i + 1],
                              position - static_cast<double>(i)),
                     angle(t), width);
    }
    // Roll and twist turn both edges about the direction of the midrib.
    if (const double turn = leaf_.roll + leaf_.twist * (t - 0.5); turn != 0) {
        const glm::dvec3 along(0, std::sin(angle(t)), std::cos(angle(t)));
        for (glm::dvec3* edge : {&row.left, &row.right})
            *edge =
                row.midrib + turned(*edge - row.midrib, along, turn * degree);
    }
    return row;
}

std::vector<BladeRow> LeafSurface::tessellate(int cells, double begin,
                                              double end) const {
    // Measure the polyline of the whole blade; below it is scaled to the leaf's
    // length and width.
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
    // The visible part begins at the stalk.
    glm::dvec3 start = base_;
    if (leaf_.hidden > 0) start = row(leaf_.hidden).midrib;
    if (begin > 0 || end < 1)
        for (int i = 0; i <= cells; ++i)
            rows[static_cast<std::size_t>(i)] =
                row(std::lerp(begin, end, static_cast<double>(i) / cells));
    const double along = leaf_.length / length;
    const double across = leaf_.width / width;
    for (BladeRow& r : rows) {
        const glm::dvec3 midrib = r.midrib;
        const glm::dvec3 moved = base_ + along * (midrib - start);
        r.left = moved + across * (r.left - midrib);
        r.right = moved + across * (r.right - midrib);
        r.midrib = moved;
    }
    return rows;
}

double length_from_tip(const Blade& blade, double area) {
    // Cumulative area from the tip by the trapezoidal rule, then its inverse by
    // linear interpolation.
    constexpr std::size_t steps = 64;
    std::array<double, steps + 1> width{}, sum{};
    for (std::size_t i = 0; i <= steps; ++i) {
        const auto n = basis(1 - static_cast<double>(i) / steps);
        for (std::size_t c = 0; c < controls_along; ++c)
            width[i] += n[c] * blade.width_controls.at(c);
        if (i > 0) sum[i] = sum[i - 1] + (width[i - 1] + width[i]) / 2;
    }
    std::size_t i = 1;
    while (i < steps && sum[i] < area * sum[steps]) ++i;
    const double rest = area * sum[steps] - sum[i - 1];
    return std::min(
        1.,
        (static_cast<double>(i - 1) + rest / (sum[i] - sum[i - 1])) / steps);
}

}  // namespace ideotype
