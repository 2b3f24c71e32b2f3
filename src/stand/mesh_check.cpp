// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <fmt/format.h>

#include "campaign/meshes.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/units.hpp"
#include "ideotype/crop/obj_reader.hpp"
#include "mesh_study.hpp"
#include "spec/problems.hpp"

namespace ideotype {

namespace {

constexpr double most_faces = most_obj_faces;

//! A height that no crop exceeds [m].
constexpr double usual_height = 20;

//! The largest number of periods that a beam may cross before it reaches the
//! soil.
constexpr double most_beam_crossings = 1e4;

//! Checks the ground area: if too small, paths cross very many periods; if too
//! large, they hardly meet the mesh.
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

//! Checks that beams from a low sun do not cross too many periods.
//! @param height height of the mesh [m]
void check_beams(double height, const Cell& cell, const MeshSpec::Sun& sun,
                 const Problems& problems) {
    const double period = std::min(cell.period_x, cell.period_y);
    const double crossings = height / std::tan(sun.elevation * degree) / period;
    const double least =
        std::atan(height / (most_beam_crossings * period)) / degree;
    problems.named_rule(
        {"sun"}, crossings > most_beam_crossings,
        "{0}: at an elevation of {1:.3g} deg light crosses the period of "
        "{2:.6g} m {3:.1e} times on its way down {4:.4g} m of mesh (the limit "
        "is {5:.0e}); give {6:.4f} deg or more",
        sun.elevation, period, crossings, height, most_beam_crossings,
        std::ceil(least * 1e4) / 1e4);
    problems.throw_wrong_usage();
}

}  // namespace

std::vector<std::string> check_mesh(const Mesh& mesh, double plants,
                                    const Cell& cell,
                                    const std::optional<MeshSpec::Sun>& sun,
                                    const Problems& problems) {
    if (plants * static_cast<double>(mesh.faces.size()) > most_faces)
        throw Error(fmt::format(
            "a field of {} plants of {} faces is too large (the limit is "
            "{:.0e} faces); use fewer plants, or a coarser mesh",
            plants, mesh.faces.size(), most_faces));
    const auto [bottom, top] = heights_of(mesh);
    std::vector<std::string> warnings;
    if (bottom < -least_depth)
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
        if (const auto excess = excess_of(mesh, plants, cell))
            throw Error("the mesh " + *excess + "; check that it is in metres");
        if (sun) check_beams(top, cell, *sun, problems);
    }
    return warnings;
}

}  // namespace ideotype
