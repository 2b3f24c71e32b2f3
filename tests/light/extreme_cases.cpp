// SPDX-License-Identifier: Apache-2.0
// Extreme suns, rays and fields.
#include <cmath>
#include <ctime>
#include <limits>

#include <fmt/format.h>

#include "extremes.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/units.hpp"
#include "lattice.hpp"

namespace ideotype {

namespace {

//! Returns a sheet over the whole period in n x n faces that share edges.
Mesh tiles(GroundPeriod period, double height, int n) {
    Mesh mesh = leaves_only();
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j)
            mesh.vertices.push_back(
                {period.x * i / n, period.y * j / n, height});
    const auto at = [n](int i, int j) {
        return static_cast<std::uint32_t>(i * (n + 1) + j);
    };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            mesh.faces.push_back(
                {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
            mesh.face_group.push_back(0);
        }
    return mesh;
}

void grazing_sun(Findings& findings) {
    const Mesh mesh = load_reference_mesh("maize1");
    double least = 1;
    for (const double elevation : {.01, .1, 1.})
        for (const double azimuth : {0., 37., 90., 180., 270.}) {
            // Processor time is measured because other work may share the
            // machine.
            const std::clock_t began = std::clock();
            const Fractions f = findings.closing(mesh, own_cell, par,
                                                 sun_from(elevation, azimuth));
            least = std::min(least, f.leaves.mean);
            findings.require(std::clock() - began < 10 * CLOCKS_PER_SEC,
                             "no hang");
        }
    findings.require(least > .85, "leaves take more than .85");
    findings.say(fmt::format("leaves absorb at least {:.3f}", least));
}

void low_sun_along_the_row(Findings& findings) {
    const Mesh mesh = load_reference_mesh("maize1");
    for (const double elevation : {10., 5., 2., .1}) {
        const Fractions f =
            findings.closing(mesh, own_cell, par, sun_from(elevation, 0));
        findings.require(f.leaves.mean > .9, "leaves take more than .9");
        findings.say(fmt::format("{} deg: {:.3f}", elevation, f.leaves.mean));
    }
}

void sun_at_the_zenith(Findings& findings) {
    const Mesh mesh = load_reference_mesh("maize1");
    const auto leaves = [&](double azimuth) {
        return findings.closing(mesh, own_cell, par, sun_from(90, azimuth))
            .leaves.mean;
    };
    const double most = std::max(std::abs(leaves(90) - leaves(0)),
                                 std::abs(leaves(123) - leaves(0)));
    findings.require(most < 1e-3, "the azimuth is of no matter");
    findings.say(fmt::format("azimuths differ by {:.1e}", most));
}

void sun_along_a_lattice_axis(Findings& findings) {
    const Mesh mesh = load_reference_mesh("maize1");
    for (const double axis : {0., 90., 180., 270.}) {
        const auto leaves = [&](double azimuth) {
            return findings
                .closing(mesh, own_cell, par, sun_from(20, azimuth), {8192, 16})
                .leaves;
        };
        findings.require_agreement(leaves(axis), leaves(axis + 1e-6), 1e-3,
                                   fmt::format("{} deg", axis));
    }
}

void clear_sky_on_the_horizon(Findings& findings) {
    const Mesh mesh = load_reference_mesh("maize1");
    for (const double zenith : {0., 89.99, 90.}) {
        const Fractions f = findings.closing(
            mesh, own_cell, par, sky_of({SkyModel::clear, {zenith, 0}}));
        findings.require(f.leaves.mean > .9, "leaves take more than .9");
    }
}

void edges_and_vertices(Findings& findings) {
    const Mesh mesh = tiles(own_cell, 0.3, 7);
    const RayScene scene(widest_device(), mesh, own_cell.x, own_cell.y);
    int through = 0, rays = 0;
    for (const double slope : {0., 1e-3, 1., 100.})
        for (int i = 0; i <= 14; ++i)
            for (int j = 0; j <= 14; ++j)
                for (const double turn : {0., 1.0, 90., 180., 271.}) {
                    const double a = turn * degree;
                    const double length = std::hypot(slope, 1.0);
                    const glm::dvec3 d{slope * std::sin(a) / length,
                                       slope * std::cos(a) / length,
                                       -1 / length};
                    // Rays start slightly above the sheet, so that they cannot
                    // leave the cell.
                    const double up = 1e-4;
                    const glm::dvec3 from{own_cell.x * i / 14 - d.x / -d.z * up,
                                          own_cell.y * j / 14 - d.y / -d.z * up,
                                          0.3 + up};
                    Hit hit;
                    ++rays;
                    through += !scene.intersect(from, d, 1, hit);
                }
    findings.require(through == 0, "no ray passes");
    findings.say(fmt::format("{} of {} rays pass", through, rays));
}

void closed_mirror(Findings& findings) {
    // Light that slipped through a seam between faces could never escape.
    const Fractions f =
        findings.closing(tiles({0.7, 0.3}, 0.3, 6), {0.7, 0.3},
                         leaf_optics(1, 0, 1), uniform_sky(), {16384, 8});
    findings.require(std::abs(f.reflected.mean - 1) < 1e-12, "all comes back");
}

Estimate leaves_of_field(Findings& findings, int n, Accuracy accuracy) {
    const FieldForm form{n, n, {.76, .15}, 0};
    const Cell cell = cell_of(form);
    return findings
        .closing(in_lattice(two_leaves(.7, .08, 40), form),
                 {cell.period_x, cell.period_y}, par, sun_from(35, 200),
                 accuracy)
        .leaves;
}

void many_plants(Findings& findings) {
    findings.require_agreement(leaves_of_field(findings, 100, {65536, 8}),
                               leaves_of_field(findings, 1, {16384, 16}), 1e-3,
                               "100 x 100");
}

void one_centimetre_apart(Findings& findings) {
    const Mesh field =
        in_lattice(two_leaves(.7, .08, 40), {1, 1, {.01, .01}, 0});
    for (const double elevation : {90., 1., .01}) {
        const Fractions f =
            findings.closing(field, {.01, .01}, par, sun_from(elevation, 10));
        findings.require(f.leaves.mean > .9, "leaves take more than .9");
        findings.require(f.soil.mean < 1e-3, "soil gets less than .001");
    }
}

void fifty_metres_apart(Findings& findings) {
    // With the sun in the zenith, a black plant far from all others absorbs the
    // light on its projected area. The same holds for four such plants in a
    // field of two rows.
    Mesh mesh = leaves_only();
    add_leaf(mesh, {-2, -2, .4}, {4, 0, 0}, {0, 4, 1});
    const Mesh field = in_lattice(mesh, {2, 2, {50, 50}, 0});
    const Fractions f = findings.closing(field, {100, 100}, black,
                                         sun_from(90, 0), {65536, 16});
    findings.require_agreement(f.leaves, {16. / 2500, 0}, 5e-5, "plant");
    findings.closing(field, {100, 100}, par, sun_from(.01, 40));
}

void ten_kilometres_away(Findings& findings) {
    const Mesh mesh = load_reference_mesh("maize1");
    Mesh moved = mesh;
    for (glm::dvec3& v : moved.vertices) v = {v.x + 1e4, v.y - 1e4, v.z};
    for (const double elevation : {3., 40.}) {
        const auto leaves = [&](const Mesh& m) {
            return findings
                .closing(m, own_cell, par, sun_from(elevation, 10), {32768, 16})
                .leaves;
        };
        findings.require_agreement(leaves(moved), leaves(mesh), 4e-4,
                                   fmt::format("{} deg", elevation));
    }
}

void vertices_beyond_reason(Findings& findings) {
    for (const double x : {9e6, 1e12, 1e30, std::numeric_limits<double>::max(),
                           std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()}) {
        Mesh mesh = leaves_only();
        add_leaf(mesh, {0, 0, 1}, {x, 0, 0}, {0, 2, 0});
        bool is_refused = false;
        try {
            const RayScene scene(widest_device(), mesh, .1, .1);
        } catch (const Error&) {
            is_refused = true;
        }
        findings.require(is_refused, fmt::format("{} m is refused", x));
    }
    findings.say("refused");
}

}  // namespace

std::vector<ExtremeCase> extreme_suns_and_fields() {
    return {
        {"sun at 0.01, 0.1, 1 deg, five azimuths",
         "leaves absorb > 0.85, and it ends", grazing_sun},
        {"sun at 10, 5, 2, 0.1 deg along the row", "leaves absorb > 0.9",
         low_sun_along_the_row},
        {"sun at the zenith", "the same from any azimuth", sun_at_the_zenith},
        {"sun exactly along a lattice axis", "the same as 1e-6 deg away",
         sun_along_a_lattice_axis},
        {"clear sky, sun at the zenith and on the horizon",
         "leaves absorb > 0.9", clear_sky_on_the_horizon},
        {"rays at edges, vertices, corners of the cell",
         "none passes a closed sheet", edges_and_vertices},
        {"closed mirror of tiles over white soil", "reflected 1",
         closed_mirror},
        {"100 x 100 plants", "the same as 1 plant", many_plants},
        {"plants 1 cm apart", "leaves absorb > 0.9, soil < 0.001",
         one_centimetre_apart},
        {"plants 50 m apart", "a black plant absorbs its projected area",
         fifty_metres_apart},
        {"field 10 km from the origin", "the same as at the origin",
         ten_kilometres_away},
        {"vertices at 9e6 m and beyond, NaN", "refused",
         vertices_beyond_reason}};
}

}  // namespace ideotype
