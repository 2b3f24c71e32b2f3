// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"
#include "ideotype/core/range.hpp"
#include "ideotype/crop/obj_reader.hpp"
#include "mesh_study.hpp"

namespace ideotype {

namespace {

constexpr double most_faces = most_obj_faces;

//! A height above that of any crop [m].
constexpr double usual_height = 20;

//! The most crossings of a periodic cell by light on its way out.
constexpr double most_crossings = 1000;

//! Checks that large faces do not have too many images in the cell.
void check_images(const Mesh& mesh, double plants, const Cell& cell) {
    double images = 0;
    for (const auto& face : mesh.faces) {
        const auto count = [&](double glm::dvec3::*axis, double period) {
            const auto [least, largest] = std::minmax(
                {mesh.vertices[face[0]].*axis, mesh.vertices[face[1]].*axis,
                 mesh.vertices[face[2]].*axis, mesh.vertices[face[3]].*axis});
            return 1 + (largest - least) / period;
        };
        images += count(&glm::dvec3::x, cell.period_x) *
                  count(&glm::dvec3::y, cell.period_y);
    }
    if (!(plants * images <= most_faces))
        throw Error(fmt::format(
            "the mesh covers its period of {} x {} m so often that {:.1e} "
            "faces would be needed (the limit is {:.0e}); check that it is "
            "in metres",
            cell.period_x, cell.period_y, plants * images, most_faces));
}

//! Returns the range of heights of the mesh and of the soil [m].
Range heights(const Mesh& mesh) {
    Range all{0, 0};
    for (const auto& face : mesh.faces)
        for (const std::uint32_t vertex : face) {
            const double z = mesh.vertices[vertex].z;
            all = {std::min(all.lower, z), std::max(all.upper, z)};
        }
    return all;
}

//! Checks that light need not fall almost for ever to meet so small an
//! area, or to leave so large an area.
void check_area(const Mesh& mesh, double plants, const Cell& cell) {
    constexpr double least = 1e-6, most = 1e4;
    double area = 0;
    for (const double each : face_areas(mesh)) area += each;
    area *= plants;
    const bool is_much = area > most * cell.ground_area;
    if (is_much || (cell.boundary == Boundary::periodic &&
                    area < least * cell.ground_area))
        throw Error(fmt::format(
            "the mesh has {:.2g} m2 over {:.4g} m2 of ground (the {} is "
            "{:.0e} of it); check that it is in metres",
            area, cell.ground_area, is_much ? "most" : "least",
            is_much ? most : least));
}

//! Checks that light need not cross a narrow cell almost for ever.
void check_height(double height, const Cell& cell) {
    const double period = std::min(cell.period_x, cell.period_y);
    if (height > most_crossings * period)
        throw Error(fmt::format(
            "the mesh is {:.6g} m high over a period of {:.6g} m (the "
            "limit is {:.0f} times the period); check that it is in metres",
            height, period, most_crossings));
}

}  // namespace

std::vector<std::string> check_mesh(const Mesh& mesh, double plants,
                                    const Cell& cell) {
    if (plants * static_cast<double>(mesh.faces.size()) > most_faces)
        throw Error(fmt::format(
            "a field of {} plants of {} faces is too large (the limit is "
            "{:.0e} faces); take fewer plants, or a coarser mesh",
            plants, mesh.faces.size(), most_faces));
    const auto [bottom, top] = heights(mesh);
    std::vector<std::string> warnings;
    constexpr double below = -1e-3;  // depth beyond rounding
    if (bottom < below)
        warnings.push_back(
            fmt::format("the mesh reaches {:.4g} m below the soil (z = 0), "
                        "where there is no light; lift it",
                        -bottom));
    if (top > usual_height)
        warnings.push_back(fmt::format(
            "the mesh is {:.4g} m high (coordinates are taken as metres); "
            "if they are centimetres, divide them by 100",
            top));
    check_area(mesh, plants, cell);
    if (cell.boundary == Boundary::periodic) {
        check_images(mesh, plants, cell);
        check_height(top, cell);
    }
    return warnings;
}

}  // namespace ideotype
