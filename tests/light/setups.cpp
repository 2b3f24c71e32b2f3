// SPDX-License-Identifier: Apache-2.0
#include "setups.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ideotype {

namespace {

using Polygon = std::vector<glm::dvec3>;

glm::dvec3 between(const glm::dvec3& a, const glm::dvec3& b, double t) {
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y),
            a.z + t * (b.z - a.z)};
}

//! Returns the part of a convex polygon in which sign * axis >= sign * at.
Polygon clipped(const Polygon& polygon, double glm::dvec3::*axis, double at,
                double sign) {
    Polygon part;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3& a = polygon[i];
        const glm::dvec3& b = polygon[(i + 1) % polygon.size()];
        const double da = sign * (a.*axis - at);
        const double db = sign * (b.*axis - at);
        if (da >= 0) part.push_back(a);
        if ((da > 0 && db < 0) || (da < 0 && db > 0))
            part.push_back(between(a, b, da / (da - db)));
    }
    return part;
}

//! Returns the parts of a polygon in strips of the given width, each moved into
//! the first strip.
std::vector<Polygon> wrapped(const Polygon& polygon, double glm::dvec3::*axis,
                             double width) {
    const auto [least, most] =
        std::minmax_element(polygon.begin(), polygon.end(),
                            [axis](const glm::dvec3& a, const glm::dvec3& b) {
                                return a.*axis < b.*axis;
                            });
    std::vector<Polygon> parts;
    for (double i = std::floor(*least.*axis / width); i * width <= *most.*axis;
         ++i) {
        Polygon part = clipped(clipped(polygon, axis, i * width, 1), axis,
                               (i + 1) * width, -1);
        for (glm::dvec3& v : part) v.*axis -= i * width;
        if (part.size() >= 3) parts.push_back(std::move(part));
    }
    return parts;
}

void add_polygon(Mesh& mesh, const Polygon& polygon, std::uint32_t group) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), polygon.begin(), polygon.end());
    for (std::uint32_t i = 2; i < polygon.size(); ++i) {
        mesh.faces.push_back({first, first + i - 1, first + i, first + i});
        mesh.face_group.push_back(group);
    }
}

void use_triangles(Setting& stand) {
    stand.mesh = as_triangles(stand.mesh);
}

void cut(Setting& stand) {
    stand.mesh = cut_and_wrapped(stand.mesh, stand.period);
}

void shift(Setting& stand) {
    for (glm::dvec3& v : stand.mesh.vertices)
        v = {v.x + 0.3719 * stand.period.x, v.y - 7.2113 * stand.period.y, v.z};
}

void repeat(Setting& stand) {
    const Mesh& one = stand.mesh;
    Mesh four;
    four.groups = one.groups;
    for (const double x : {0., stand.period.x})
        for (const double y : {0., stand.period.y}) {
            const auto first = static_cast<std::uint32_t>(four.vertices.size());
            for (const glm::dvec3& v : one.vertices)
                four.vertices.push_back({v.x + x, v.y + y, v.z});
            for (const auto& [a, b, c, d] : one.faces)
                four.faces.push_back(
                    {first + a, first + b, first + c, first + d});
            four.face_group.insert(four.face_group.end(),
                                   one.face_group.begin(),
                                   one.face_group.end());
        }
    stand = {std::move(four),
             {2 * stand.period.x, 2 * stand.period.y},
             std::move(stand.light)};
}

void turn(Setting& stand) {
    for (glm::dvec3& v : stand.mesh.vertices) v = {-v.y, v.x, v.z};
    std::swap(stand.period.x, stand.period.y);
    for (Source& source : stand.light.sources)
        if (source.direction) {
            const glm::dvec3& d = *source.direction;
            source.direction = glm::dvec3{-d.y, d.x, d.z};
        }
}

}  // namespace

std::vector<Setup> setups() {
    std::vector<std::string> isas = Device::supported_isas();
    const std::string widest = isas.back();
    isas.pop_back();
    std::vector<Setup> all{{"usual, " + widest, widest}};
    for (const std::string& isa : isas) all.push_back({isa, isa});
    all.push_back({"another seed", widest, 2});
    all.push_back({"four times the randomisations", widest, 1, 4});
    all.push_back({"triangles", widest, 1, 1, use_triangles});
    all.push_back({"cut and wrapped", widest, 1, 1, cut});
    all.push_back({"shifted", widest, 1, 1, shift});
    all.push_back({"2 x 2 periods", widest, 1, 1, repeat});
    all.push_back({"turned by 90 deg", widest, 1, 1, turn});
    return all;
}

Mesh as_triangles(const Mesh& mesh) {
    Mesh result{mesh.vertices, {}, {}, mesh.groups};
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const auto [a, b, c, d] = mesh.faces[f];
        if (c == d) {
            const auto middle =
                static_cast<std::uint32_t>(result.vertices.size());
            result.vertices.push_back(
                between(mesh.vertices[b], mesh.vertices[c], .5));
            result.faces.push_back({a, b, middle, middle});
            result.faces.push_back({a, middle, c, c});
        } else {
            // The ray tracer splits a quadrilateral along this diagonal.
            result.faces.push_back({a, b, d, d});
            result.faces.push_back({c, d, b, b});
        }
        result.face_group.insert(result.face_group.end(), 2,
                                 mesh.face_group[f]);
    }
    return result;
}

Mesh cut_and_wrapped(const Mesh& mesh, GroundPeriod period) {
    Mesh result;
    result.groups = mesh.groups;
    const Mesh triangles = as_triangles(mesh);
    for (std::size_t f = 0; f < triangles.faces.size(); ++f) {
        Polygon triangle;
        for (std::size_t i = 0; i < 3; ++i)
            triangle.push_back(triangles.vertices[triangles.faces[f][i]]);
        for (const Polygon& strip : wrapped(triangle, &glm::dvec3::x, period.x))
            for (const Polygon& part : wrapped(strip, &glm::dvec3::y, period.y))
                add_polygon(result, part, triangles.face_group[f]);
    }
    return result;
}

}  // namespace ideotype
