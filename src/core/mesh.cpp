#include "ideotype/core/mesh.hpp"

#include <cmath>

namespace ideotype {

namespace {

double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 u{b.x - a.x, b.y - a.y, b.z - a.z};
    const Vec3 v{c.x - a.x, c.y - a.y, c.z - a.z};
    const Vec3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z,
                 u.x * v.y - u.y * v.x};
    return 0.5 * std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
}

}  // namespace

std::vector<double> face_areas(const Mesh& mesh) {
    std::vector<double> areas;
    areas.reserve(mesh.faces.size());
    for (const auto& face : mesh.faces) {
        const Vec3& a = mesh.vertices[face[0]];
        const Vec3& b = mesh.vertices[face[1]];
        const Vec3& c = mesh.vertices[face[2]];
        const Vec3& d = mesh.vertices[face[3]];
        // The ray tracer splits a quadrilateral along this diagonal too.
        areas.push_back(triangle_area(a, b, d) + triangle_area(c, d, b));
    }
    return areas;
}

double leaf_area(const Mesh& mesh) {
    const std::vector<double> areas = face_areas(mesh);
    double sum = 0;
    for (std::size_t f = 0; f < areas.size(); ++f)
        if (mesh.groups[mesh.face_group[f]].tissue == Tissue::leaf)
            sum += areas[f];
    return sum;
}

}  // namespace ideotype
