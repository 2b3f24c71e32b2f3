// SPDX-License-Identifier: Apache-2.0
#include "ideotype/light/leaf_points.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "ideotype/core/contract.hpp"
#include "repeated_faces.hpp"

namespace ideotype {

double own_part(const RayScene& scene, const LeafPoint& point) {
    if (point.is_hidden) return 0;
    return 1. / std::max(1, scene.faces_at(scene.placed(point.position)));
}

LeafPoints::LeafPoints(const Mesh& mesh, const Wanted& is_wanted) {
    IDEOTYPE_EXPECT(mesh.face_group.size() == mesh.faces.size());
    const std::vector<bool> repeated = repeated_faces(mesh);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const std::uint32_t group = mesh.face_group[f];
        if (!is_wanted(group)) continue;
        const auto& [a, b, c, d] = mesh.faces[f];
        const auto& v = mesh.vertices;
        add(v[a], v[b], v[d], group, repeated[f]);
        add(v[c], v[d], v[b], group, repeated[f]);
    }
}

LeafPoints::LeafPoints(const Mesh& mesh)
    : LeafPoints(mesh, [&mesh](std::uint32_t group) {
          return mesh.groups[group].id.is_leaf();
      }) {}

LeafPoint LeafPoints::at(double share, double s, double t) const {
    IDEOTYPE_EXPECT(!ends_.empty() && share >= 0 && share < 1);
    const auto found =
        std::upper_bound(ends_.begin(), ends_.end() - 1, share * area());
    const Triangle& triangle =
        triangles_[static_cast<std::size_t>(found - ends_.begin())];
    if (s + t > 1) {
        s = 1 - s;
        t = 1 - t;
    }
    const glm::dvec3 position =
        triangle.corner + s * triangle.u + t * triangle.v;
    return {position, triangle.normal, triangle.group,
            position.z < 0 || triangle.is_repeated};
}

void LeafPoints::add(const glm::dvec3& a, const glm::dvec3& b,
                     const glm::dvec3& c, std::uint32_t group,
                     bool is_repeated) {
    const glm::dvec3 u = b - a, v = c - a;
    const glm::dvec3 n = glm::cross(u, v);
    const double twice = glm::length(n);
    if (!(twice > 0)) return;
    triangles_.push_back({a, u, v, n / twice, group, is_repeated});
    ends_.push_back(area() + twice / 2);
}

}  // namespace ideotype
