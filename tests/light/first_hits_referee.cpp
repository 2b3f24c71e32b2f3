// SPDX-License-Identifier: Apache-2.0
#include "first_hits_referee.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "beams/beam_lattice.hpp"
#include "beams/depth_buffer.hpp"
#include "beams/directions.hpp"
#include "extremes.hpp"
#include "paths/travel.hpp"

namespace ideotype {

namespace {

//! The surface that is hit first; the soil has neither group nor side.
struct Seen {
    bool is_soil;
    std::uint32_t group;
    bool is_adaxial;
    double height;
};

//! Returns whether two surfaces are equal, within the single precision of
//! coordinates and distances.
bool is_same(const Seen& a, const Seen& b) {
    if (a.is_soil || b.is_soil) return a.is_soil == b.is_soil;
    return a.group == b.group && a.is_adaxial == b.is_adaxial &&
           std::abs(a.height - b.height) < 1e-4;
}

//! Finds the surface by a ray that comes from above through a point of the
//! beam.
Seen by_ray(const RayScene& scene, const glm::dvec3& direction,
            const glm::dvec3& point) {
    const double up = (scene.top() - point.z) / direction.z;
    glm::dvec3 from = scene.wrapped(point + up * direction);
    from.z = scene.top();
    const Hit hit = travel(scene, from, direction);
    if (hit.group == Hit::soil) return {true, 0, false, 0};
    return {false, hit.group, glm::dot(direction, hit.normal) < 0,
            hit.position.z};
}

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

//! Finds the surface by testing all images of all faces in double precision.
class Exact {
  public:
    Exact(const RayScene& scene, const glm::dvec3& direction,
          const glm::dvec3& point)
        : scene_(scene),
          direction_(direction),
          ground_(on_ground(point)),
          seen_{true, 0, false, scene.soil()} {
        const Surfaces& all = scene.surfaces();
        for (std::size_t f = 0; f < all.faces.size(); ++f) {
            const auto& [a, b, c, d] = all.faces[f];
            const auto& v = all.vertices;
            look(all.face_group[f], v[a], v[b], v[d]);
            look(all.face_group[f], v[c], v[d], v[b]);
        }
    }

    const Seen& seen() const { return seen_; }

  private:
    glm::dvec2 on_ground(const glm::dvec3& p) const {
        return {p.x - p.z * (direction_.x / direction_.z),
                p.y - p.z * (direction_.y / direction_.z)};
    }

    void look(std::uint32_t group, const glm::dvec3& a, const glm::dvec3& b,
              const glm::dvec3& c) {
        const glm::dvec2 pa = on_ground(a), pb = on_ground(b),
                         pc = on_ground(c);
        const double area = cross(pb - pa, pc - pa);
        if (area == 0) return;
        const auto first = [](double least, double at, double period) {
            return std::ceil((least - at) / period);
        };
        const auto [x0, x1] = std::minmax({pa.x, pb.x, pc.x});
        const auto [y0, y1] = std::minmax({pa.y, pb.y, pc.y});
        const double px = scene_.period_x(), py = scene_.period_y();
        for (double i = first(x0, ground_.x, px); ground_.x + i * px <= x1; ++i)
            for (double j = first(y0, ground_.y, py); ground_.y + j * py <= y1;
                 ++j) {
                const glm::dvec2 p = ground_ + glm::dvec2{i * px, j * py};
                const double of_a = cross(pb - p, pc - p) / area;
                const double of_b = cross(pc - p, pa - p) / area;
                const double of_c = cross(pa - p, pb - p) / area;
                if (std::min({of_a, of_b, of_c}) < 0) continue;
                const double height = of_a * a.z + of_b * b.z + of_c * c.z;
                if (height > seen_.height)
                    seen_ = {false, group, area > 0, height};
            }
    }

    const RayScene& scene_;
    glm::dvec3 direction_;
    glm::dvec2 ground_;
    Seen seen_;
};

class Referee {
  public:
    Referee(std::string name, const Mesh& mesh, GroundPeriod period, int points)
        : scene_(widest_device(), mesh, period.x, period.y),
          result_{std::move(name)},
          points_(points) {}

    void compare(double elevation, double azimuth) {
        const glm::dvec3 direction =
            not_level(*sun_from(elevation, azimuth).sources[0].direction);
        const std::vector<glm::dvec2> shifts{{.123, .777}, {.61, .05}};
        // When the sun is low, each point has many faces on its line of sight,
        // so that fewer points are tested.
        const double fewer = std::min(1., 20 * -direction.z);
        const DepthBuffer buffer(
            scene_, direction,
            beam_lattice(scene_.period_x(), scene_.period_y(),
                         1 + static_cast<std::int64_t>(fewer * points_), 7,
                         direction),
            shifts);
        for (std::size_t r = 0; r < shifts.size(); ++r)
            for (std::size_t i = 0; i < buffer.points(); ++i)
                compare(direction, seen(buffer, r, i), buffer.position(r, i));
    }

    const FirstHitsCompared& result() const { return result_; }

  private:
    Seen seen(const DepthBuffer& buffer, std::size_t r, std::size_t i) const {
        const DepthBuffer::Triangle triangle = buffer.triangle(r, i);
        if (triangle.is_soil()) return {true, 0, false, 0};
        return {false, scene_.surfaces().face_group[triangle.face()],
                triangle.is_adaxial(), buffer.height(r, i)};
    }

    void compare(const glm::dvec3& direction, const Seen& drawn,
                 const glm::dvec3& point) {
        ++result_.points;
        if (is_same(drawn, by_ray(scene_, direction, point))) return;
        ++result_.differ;
        if (!is_same(drawn, Exact(scene_, direction, point).seen()))
            ++result_.wrong;
    }

    RayScene scene_;
    FirstHitsCompared result_;
    int points_;
};

Mesh vertical() {
    Mesh mesh = leaves_only();
    add_leaf(mesh, {.3, .2, .1}, {0, .5, 0}, {0, 0, 1});
    add_leaf(mesh, {.1, .7, .1}, {.8, 0, 0}, {0, 0, 1});
    return mesh;
}

//! Returns horizontal leaves that share edges, at the edges and corners of the
//! cell too.
Mesh tiles() {
    Mesh mesh = leaves_only();
    for (const double x : {0., .25, .5, .75})
        for (const double y : {0., .5})
            add_leaf(mesh, {x, y, .3}, {.25, 0, 0}, {0, .5, 0});
    return mesh;
}

//! Returns leaves that lie on, cross or lie below the surface of the soil.
Mesh at_the_soil() {
    Mesh mesh = leaves_only();
    add_leaf(mesh, {.1, .1, 0}, {.3, 0, 0}, {0, .3, 0});
    add_leaf(mesh, {.5, .2, -.2}, {.3, 0, 0}, {0, .2, .4});
    add_leaf(mesh, {.5, .6, -.1}, {.3, 0, 0}, {0, .3, 0});
    return mesh;
}

//! Returns coincident faces. Of faces with the same corners, light hits the
//! first.
Mesh on_each_other() {
    Mesh mesh = leaves_only();
    mesh.groups.push_back({"again"});
    mesh.groups.push_back({"reversed"});
    add_leaf(mesh, {.2, .2, .5}, {.6, 0, .1}, {0, .5, .2});
    mesh.faces.push_back(mesh.faces[0]);
    mesh.faces.push_back({3, 2, 1, 0});
    mesh.face_group = {0, 1, 2};
    return mesh;
}

//! Returns a leaf that is longer than the cell, so that it overlaps its own
//! image.
Mesh overhanging() {
    Mesh mesh = leaves_only();
    add_leaf(mesh, {.9, .2, .1}, {2.6, 0, .8}, {.1, .4, 0});
    return mesh;
}

}  // namespace

std::vector<FirstHitsCompared> compare_first_hits(int points) {
    std::vector<FirstHitsCompared> all;
    const auto add = [&](const std::string& name, const Mesh& mesh,
                         GroundPeriod period) {
        Referee referee(name, mesh, period, points);
        for (const double elevation : {90., 60., 30., 10., 1., .1, .01})
            for (const double azimuth : {0., 37., 90., 200.})
                referee.compare(elevation, azimuth);
        all.push_back(referee.result());
    };
    add("maize1", load_reference_mesh("maize1"), own_cell);
    for (const char* name : {"poisson_horizontal_L3", "poisson_spherical_L3",
                             "sheets1", "sheets5"})
        add(name, load_reference_mesh(name), unit_cell);
    add("vertical leaves", vertical(), unit_cell);
    add("tiles", tiles(), unit_cell);
    add("at the soil", at_the_soil(), unit_cell);
    add("faces on each other", on_each_other(), unit_cell);
    add("longer than the cell", overhanging(), unit_cell);
    return all;
}

}  // namespace ideotype
