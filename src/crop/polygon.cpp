// SPDX-License-Identifier: Apache-2.0
#include "ideotype/crop/polygon.hpp"

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

namespace ideotype {

namespace {

//! Areas below this fraction of the squared diameter are considered rounding
//! errors.
constexpr double negligible = 1e-12;

//! Largest number of corners visited when a polygon is split, which takes about
//! a second.
constexpr std::size_t most_visits = 300'000'000;

double cross(const glm::dvec2& u, const glm::dvec2& v) {
    return u.x * v.y - u.y * v.x;
}

//! A polygon projected onto its mean plane, counter-clockwise.
class Outline {
  public:
    Outline(const std::vector<glm::dvec3>& vertices, const Corners& corners) {
        const glm::dvec3 origin = vertices[corners.front()];
        std::vector<glm::dvec3> points;
        for (const std::uint32_t corner : corners)
            points.push_back(vertices[corner] - origin);
        // The sum of cross products of a fan is twice the area vector (Newell).
        glm::dvec3 normal(0);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const glm::dvec3 twice_area = glm::cross(points[i], points[i + 1]);
            normal += twice_area;
            fan_area_ += glm::length(twice_area);
            size_ = std::max(size_, glm::dot(points[i + 1], points[i + 1]));
        }
        area_ = glm::length(normal);
        const glm::dvec3 n = area_ > 0 ? normal / area_ : glm::dvec3(0, 0, 1);
        const glm::dvec3 helper =
            std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        const glm::dvec3 u = glm::normalize(glm::cross(helper, n));
        const glm::dvec3 v = glm::cross(n, u);
        for (const glm::dvec3& p : points)
            points_.emplace_back(glm::dot(p, u), glm::dot(p, v));
    }

    bool has_area() const { return fan_area_ > negligible * size_; }

    //! Returns whether the polygon has a mean plane. It has none if parts that
    //! turn in opposite directions cancel.
    bool has_plane() const { return area_ > negligible * size_; }

    //! Returns twice the area of a triangle, negative if it turns clockwise.
    double turn(std::size_t a, std::size_t b, std::size_t c) const {
        return cross(points_[b] - points_[a], points_[c] - points_[a]);
    }

    bool is_inside(std::size_t p, std::size_t a, std::size_t b,
                   std::size_t c) const {
        return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
    }

    bool coincide(std::size_t a, std::size_t b) const {
        return points_[a] == points_[b];
    }

    //! Returns whether the polygon can be split into triangles that join one
    //! corner to the edges, without overlap.
    bool is_fan(std::size_t hub) const {
        const std::size_t n = points_.size();
        for (std::size_t i = 1; i + 1 < n; ++i)
            if (turn(hub, (hub + i) % n, (hub + i + 1) % n) <
                -negligible * size_)
                return false;
        return true;
    }

  private:
    std::vector<glm::dvec2> points_;
    double area_ = 0;      //!< twice the signed area
    double fan_area_ = 0;  //!< twice the sum of areas without signs
    double size_ = 0;      //!< squared diameter
};

//! Splits a polygon by ear clipping: repeatedly cuts off a corner with a
//! triangle that contains no other corner (Meisters 1975,
//! doi:10.1080/00029890.1975.11993898).
class EarClipping {
  public:
    EarClipping(const Outline& outline, const Corners& corners)
        : outline_(outline), corners_(corners) {
        for (std::size_t i = 0; i < corners.size(); ++i) left_.push_back(i);
    }

    SplitPolygon run() {
        SplitPolygon result;
        std::size_t at = 0;
        std::size_t tried = 0;
        while (left_.size() > 3 && tried < left_.size()) {
            if (visits_ > most_visits) return {PolygonKind::intricate, {}};
            at %= left_.size();
            if (is_ear(at)) {
                result.faces.push_back(triangle(before(at), at, after(at)));
                left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
                tried = 0;
            } else {
                ++at;
                ++tried;
            }
        }
        // No ear is left if the outline crosses itself.
        if (left_.size() > 3) result.kind = PolygonKind::crossing;
        for (std::size_t i = 1; i + 1 < left_.size(); ++i)
            result.faces.push_back(triangle(0, i, i + 1));
        return result;
    }

  private:
    std::size_t before(std::size_t i) const {
        return (i + left_.size() - 1) % left_.size();
    }

    std::size_t after(std::size_t i) const { return (i + 1) % left_.size(); }

    std::array<std::uint32_t, 4> triangle(std::size_t a, std::size_t b,
                                          std::size_t c) const {
        const std::uint32_t last = corners_[left_[c]];
        return {corners_[left_[a]], corners_[left_[b]], last, last};
    }

    bool is_ear(std::size_t at) {
        const std::size_t a = left_[before(at)];
        const std::size_t b = left_[at];
        const std::size_t c = left_[after(at)];
        if (!(outline_.turn(a, b, c) >= 0)) return false;
        visits_ += left_.size();
        // The outline of a polygon with holes visits some points twice; ignore
        // such copies of a, b and c.
        return std::none_of(left_.begin(), left_.end(), [&](std::size_t p) {
            return !outline_.coincide(p, a) && !outline_.coincide(p, b) &&
                   !outline_.coincide(p, c) && outline_.is_inside(p, a, b, c);
        });
    }

    const Outline& outline_;
    const Corners& corners_;
    std::vector<std::size_t> left_;
    std::size_t visits_ = 0;  //!< corners visited in all tried ears
};

void remove_repeated(Corners& corners) {
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    while (corners.size() > 1 && corners.front() == corners.back())
        corners.pop_back();
}

//! Splits a polygon into the triangles between its first corner and its edges.
SplitPolygon split_as_fan(const Corners& corners, PolygonKind kind) {
    SplitPolygon result{kind, {}};
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        result.faces.push_back(
            {corners[0], corners[i], corners[i + 1], corners[i + 1]});
    return result;
}

}  // namespace

SplitPolygon split_polygon(const std::vector<glm::dvec3>& vertices,
                           Corners corners) {
    remove_repeated(corners);
    if (corners.size() < 3) return {PolygonKind::without_area, {}};
    const Outline outline(vertices, corners);
    if (!outline.has_area()) return {PolygonKind::without_area, {}};
    if (corners.size() == 3) return split_as_fan(corners, PolygonKind::simple);
    if (!outline.has_plane())
        return split_as_fan(corners, PolygonKind::crossing);
    if (corners.size() == 4) {
        // A quadrilateral is two triangles that share its second and last
        // corner; the usual diagonal joins the first and third corner.
        const Corners& c = corners;
        if (outline.is_fan(0)) return {{}, {{c[1], c[2], c[3], c[0]}}};
        if (outline.is_fan(1)) return {{}, {{c[0], c[1], c[2], c[3]}}};
    }
    if (outline.is_fan(0)) return split_as_fan(corners, PolygonKind::simple);
    return EarClipping(outline, corners).run();
}

}  // namespace ideotype
