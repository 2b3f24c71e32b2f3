// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "blades.hpp"
#include "ideotype/canopy/pieces.hpp"

namespace ideotype {

namespace {

//! Returns the length of a blade's edges that have a single face [m].
double circumference(const Mesh& mesh, const Faces& blade) {
    using Place = std::array<double, 3>;
    std::vector<std::pair<Place, Place>> edges;
    for (const std::uint32_t f : blade) {
        const auto& face = mesh.faces[f];
        for (std::size_t i = 0; i < face.size(); ++i) {
            const glm::dvec3& a = mesh.vertices[face[i]];
            const glm::dvec3& b = mesh.vertices[face[(i + 1) % face.size()]];
            if (a == b) continue;
            const Place first{a.x, a.y, a.z}, second{b.x, b.y, b.z};
            edges.push_back(std::minmax(first, second));
        }
    }
    std::sort(edges.begin(), edges.end());
    double length = 0;
    for (std::size_t i = 0, next = 0; i < edges.size(); i = next) {
        while (next < edges.size() && edges[next] == edges[i]) ++next;
        const auto& [a, b] = edges[i];
        if (next - i == 1)
            length += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
    return length;
}

}  // namespace

std::vector<double> blade_widths(const Mesh& mesh) {
    const std::vector<double> areas = face_areas(mesh);
    std::vector<double> widths(mesh.groups.size()), all(mesh.groups.size());
    for (const Faces& blade : blades(mesh)) {
        double area = 0;
        for (const std::uint32_t f : blade) area += areas[f];
        const double around = circumference(mesh, blade);
        const std::uint32_t group = mesh.face_group[blade.front()];
        widths[group] +=
            area *
            (around - std::sqrt(std::max(around * around - 16 * area, 0.))) / 4;
        all[group] += area;
    }
    for (std::size_t g = 0; g < widths.size(); ++g)
        widths[g] = all[g] > 0 ? widths[g] / all[g] : 0;
    return widths;
}

}  // namespace ideotype
