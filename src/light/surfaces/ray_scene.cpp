// SPDX-License-Identifier: Apache-2.0
#include "ideotype/light/ray_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"
#include "repeated_faces.hpp"

namespace ideotype {

namespace {

//! The largest distance of a vertex from the origin [m] and the largest number
//! of faces of a scene; larger values indicate wrong input.
constexpr double farthest = 1e7;
constexpr std::size_t most_faces = 100'000'000;

Interval interval(const std::vector<glm::dvec3>& vertices,
                  const std::array<std::uint32_t, 4>& face, int axis) {
    Interval all;
    for (const std::uint32_t v : face) all.include(vertices[v][axis]);
    return all;
}

//! The range of whole periods by which an extent can be shifted to touch [0,
//! period].
struct Shifts {
    long first;
    long last;

    double count() const { return static_cast<double>(last - first + 1); }
};

Shifts shifts_into(const Interval& extent, double period) {
    // A face that only touches the boundary is stored on both sides, so that
    // rounding cannot open a gap there.
    const double margin = 1e-6 * period;
    return {static_cast<long>(std::ceil((-margin - extent.upper) / period)),
            static_cast<long>(
                std::floor((period + margin - extent.lower) / period))};
}

void check_vertices(const Mesh& mesh) {
    for (const glm::dvec3& v : mesh.vertices)
        if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
            throw Error(
                "a vertex of the canopy is not finite; correct its "
                "coordinates");
        else if (std::abs(v.x) > farthest || std::abs(v.y) > farthest ||
                 std::abs(v.z) > farthest)
            throw Error(fmt::format(
                "a vertex of the canopy is at {:.3g} {:.3g} {:.3g} m, more "
                "than {:.0e} m away; give coordinates in metres",
                v.x, v.y, v.z, farthest));
}

double wrapped_into(double x, double period) {
    const double w = x - period * std::floor(x / period);
    return w < period ? w : 0;
}

//! Returns the orientation index of a group; 0 for unknown groups.
std::uint32_t pose_of(const Mesh& mesh, std::uint32_t group) {
    return group < mesh.groups.size() ? mesh.groups[group].pose : 0;
}

}  // namespace

std::optional<Segment> clip(const Box& box, const glm::dvec3& origin,
                            const glm::dvec3& direction) {
    Segment inside{0, std::numeric_limits<double>::infinity()};
    const auto cut = [&](double lower, double upper, double x, double dx) {
        if (dx == 0) return lower <= x && x <= upper;
        const double to_lower = (lower - x) / dx;
        const double to_upper = (upper - x) / dx;
        inside.first = std::max(inside.first, std::min(to_lower, to_upper));
        inside.last = std::min(inside.last, std::max(to_lower, to_upper));
        return true;
    };
    if (!cut(box.lower.x, box.upper.x, origin.x, direction.x) ||
        !cut(box.lower.y, box.upper.y, origin.y, direction.y) ||
        !cut(box.lower.z, box.upper.z, origin.z, direction.z) ||
        inside.first > inside.last)
        return std::nullopt;
    return inside;
}

RayScene::RayScene(const Device& device, const Mesh& mesh, double period_x,
                   double period_y, BoxTree tree)
    : ground_area_(period_x * period_y),
      period_x_(period_x),
      period_y_(period_y) {
    if (!(period_x > 0) || !(period_y > 0) || !std::isfinite(period_x) ||
        !std::isfinite(period_y))
        throw Error(
            fmt::format("the period is {} x {} m; give two distances above 0",
                        period_x, period_y));
    IDEOTYPE_EXPECT(mesh.face_group.size() == mesh.faces.size());
    check_vertices(mesh);
    const std::vector<double> areas = face_areas(mesh);
    // The reserved memory usually suffices for the images of faces that extend
    // over the edge.
    constexpr double images = 1.5;
    const auto expected = static_cast<std::size_t>(
        images * static_cast<double>(mesh.faces.size()));
    standing_.corners.reserve(4 * expected);
    standing_.face.reserve(expected);
    surface_area_ = std::accumulate(areas.begin(), areas.end(), 0.);
    surfaces_.vertices = mesh.vertices;
    surfaces_.faces.reserve(mesh.faces.size());
    surfaces_.face_group.reserve(mesh.faces.size());
    surfaces_.face_pose.reserve(mesh.faces.size());
    surfaces_.normals.reserve(2 * mesh.faces.size());
    const std::vector<bool> repeated = repeated_faces(mesh);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        if (areas[f] > 0 && !repeated[f])
            add_images(mesh.faces[f], mesh.face_group[f],
                       pose_of(mesh, mesh.face_group[f]));
    top_ += 1e-3;
    clearance_ = 4 * std::numeric_limits<float>::epsilon() *
                 std::max({period_x, period_y, top_});
    commit(device, tree);
}

RayScene RayScene::isolated(const Device& device, const Mesh& mesh,
                            double ground_area, BoxTree tree) {
    if (!(ground_area > 0) || !std::isfinite(ground_area))
        throw Error(fmt::format("the ground area is {} m2; give one above 0",
                                ground_area));
    IDEOTYPE_EXPECT(mesh.face_group.size() == mesh.faces.size());
    check_vertices(mesh);
    RayScene scene;
    scene.boundary_ = Boundary::isolated;
    scene.ground_area_ = ground_area;
    scene.add_plot(mesh, face_areas(mesh));
    scene.top_ = scene.box_.upper.z + 1e-3;
    scene.clearance_ =
        4 * std::numeric_limits<float>::epsilon() *
        std::max({scene.box_.upper.x, scene.box_.upper.y, scene.top_});
    scene.commit(device, tree);
    return scene;
}

void RayScene::add_plot(const Mesh& mesh, const std::vector<double>& areas) {
    const std::vector<bool> repeated = repeated_faces(mesh);
    const auto is_there = [&](std::size_t f) {
        const auto& face = mesh.faces[f];
        return areas[f] > 0 && !repeated[f] &&
               std::any_of(face.begin(), face.end(), [&](std::uint32_t v) {
                   return mesh.vertices[v].z >= 0;
               });
    };
    Interval x, y, z;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        if (!is_there(f)) continue;
        for (const std::uint32_t v : mesh.faces[f]) {
            x.include(mesh.vertices[v].x);
            y.include(mesh.vertices[v].y);
            z.include(std::max(0.0, mesh.vertices[v].z));
        }
    }
    if (!(x.lower <= x.upper)) return;
    plot_corner_ = {x.lower, y.lower, 0};
    box_ = {{0, 0, z.lower}, {x.upper - x.lower, y.upper - y.lower, z.upper}};
    surfaces_.vertices = mesh.vertices;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        if (!is_there(f)) continue;
        add_image(add_face(mesh.faces[f], mesh.face_group[f], 0,
                           interval(mesh.vertices, mesh.faces[f], 2)),
                  {-x.lower, -y.lower, 0});
    }
}

glm::dvec3 RayScene::wrapped(const glm::dvec3& point) const {
    if (boundary_ == Boundary::isolated) return point;
    return {wrapped_into(point.x, period_x_), wrapped_into(point.y, period_y_),
            point.z};
}

glm::dvec3 RayScene::offset_origin(const glm::dvec3& point,
                                   const glm::dvec3& normal) const {
    IDEOTYPE_EXPECT(std::abs(glm::dot(normal, normal) - 1) < 1e-6);
    glm::dvec3 offset = point + clearance_ * normal;
    offset.z = std::clamp(offset.z, soil(), top_);
    return wrapped(offset);
}

void Surfaces::add(const std::array<std::uint32_t, 4>& face,
                   std::uint32_t group, std::uint32_t pose) {
    IDEOTYPE_EXPECT(std::ranges::max(face) < vertices.size());
    faces.push_back(face);
    face_group.push_back(group);
    face_pose.push_back(pose);
    const auto normal = [&](int i, int j, int k) {
        const glm::dvec3 a = vertices[face[i]];
        const glm::dvec3 n =
            glm::cross(vertices[face[j]] - a, vertices[face[k]] - a);
        const double length = glm::length(n);
        return length > 0 ? n / length : glm::dvec3(0);
    };
    normals.push_back(normal(0, 1, 3));
    // By rounding, a hit on a triangular face may be in its second half, which
    // has no area.
    normals.push_back(face[2] == face[3] ? normals.back() : normal(2, 3, 1));
}

void RayScene::add_images(const std::array<std::uint32_t, 4>& face,
                          std::uint32_t group, std::uint32_t pose) {
    const Interval z = interval(surfaces_.vertices, face, 2);
    if (z.upper < 0) return;
    Part& part = add_face(face, group, pose, z);
    top_ = std::max(top_, z.upper);
    const Interval x = interval(surfaces_.vertices, face, 0);
    const Interval y = interval(surfaces_.vertices, face, 1);
    const Shifts along_x = shifts_into(x, period_x_);
    const Shifts along_y = shifts_into(y, period_y_);
    if (static_cast<double>(standing_.face.size()) +
            along_x.count() * along_y.count() >
        static_cast<double>(most_faces))
        throw Error(
            fmt::format("the canopy has more than {} faces in a period of {} x "
                        "{} m (large faces count once for each period that "
                        "they touch); give a smaller or coarser mesh",
                        most_faces, period_x_, period_y_));
    for (long i = along_x.first; i <= along_x.last; ++i)
        for (long j = along_y.first; j <= along_y.last; ++j)
            add_image(part, {static_cast<double>(i) * period_x_,
                             static_cast<double>(j) * period_y_, 0});
}

RayScene::Part& RayScene::add_face(const std::array<std::uint32_t, 4>& face,
                                   std::uint32_t group, std::uint32_t pose,
                                   const Interval& heights) {
    surfaces_.add(face, group, pose);
    while (moving_.size() < pose) moving_.emplace_back();
    Part& part = pose == 0 ? standing_ : moving_[pose - 1];
    if (group >= group_heights_.size()) group_heights_.resize(group + 1);
    for (Interval* each : {&group_heights_[group], &part.heights}) {
        each->include(heights.lower);
        each->include(heights.upper);
    }
    return part;
}

void RayScene::add_image(Part& part, const glm::dvec3& shift) const {
    for (const std::uint32_t v : surfaces_.faces.back()) {
        const glm::dvec3 p = surfaces_.vertices[v] + shift;
        part.corners.push_back({static_cast<float>(p.x),
                                static_cast<float>(p.y),
                                static_cast<float>(p.z), 0});
    }
    part.face.push_back(static_cast<std::uint32_t>(surfaces_.faces.size() - 1));
}

}  // namespace ideotype
