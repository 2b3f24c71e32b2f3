// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/mesh.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

double triangle_area(const glm::dvec3& a, const glm::dvec3& b,
                     const glm::dvec3& c) {
    return 0.5 * glm::length(glm::cross(b - a, c - a));
}

}  // namespace

std::vector<double> face_areas(const Mesh& mesh) {
    std::vector<double> areas;
    areas.reserve(mesh.faces.size());
    for (const auto& face : mesh.faces) {
        IDEOTYPE_EXPECT(std::ranges::max(face) < mesh.vertices.size());
        const glm::dvec3& a = mesh.vertices[face[0]];
        const glm::dvec3& b = mesh.vertices[face[1]];
        const glm::dvec3& c = mesh.vertices[face[2]];
        const glm::dvec3& d = mesh.vertices[face[3]];
        // The ray tracer splits quadrilaterals along the same diagonal, b-d.
        areas.push_back(triangle_area(a, b, d) + triangle_area(c, d, b));
    }
    return areas;
}

PlantArea plant_area(const Mesh& mesh) {
    IDEOTYPE_EXPECT(mesh.face_group.size() == mesh.faces.size());
    const std::vector<double> areas = face_areas(mesh);
    PlantArea sum;
    for (std::size_t f = 0; f < areas.size(); ++f) {
        IDEOTYPE_EXPECT(mesh.face_group[f] < mesh.groups.size());
        const SurfaceId& id = mesh.groups[mesh.face_group[f]].id;
        if (id.is_leaf())
            sum.leaves += areas[f];
        else if (!id.is_object())
            sum.other_organs += areas[f] / 2;
    }
    return sum;
}

}  // namespace ideotype
