// SPDX-License-Identifier: Apache-2.0
// Extreme leaves and optical properties.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "extremes.hpp"
#include "ideotype/core/units.hpp"
#include "lattice.hpp"

namespace ideotype {

namespace {

void vertical_leaves(Findings& findings) {
    Mesh mesh = leaves_only();
    add_leaf(mesh, {.3, .2, .1}, {0, .5, 0}, {0, 0, 1});
    add_leaf(mesh, {.1, .7, .1}, {.8, 0, 0}, {0, 0, 1});
    const Fractions zenith =
        findings.closing(mesh, unit_cell, black, sun_from(90, 0));
    findings.require(zenith.leaves.mean == 0, "nothing from the zenith");
    const Fractions side =
        findings.closing(mesh, unit_cell, black, sun_from(80, 90), {16384, 16});
    findings.require_agreement(side.leaves, {.5 * std::tan(10 * degree), 0},
                               3e-4, "side");
}

void upright_plant(Findings& findings) {
    const Mesh field =
        in_lattice(two_leaves(.7, .08, 0), {1, 1, {.76, .15}, 0});
    for (const double elevation : {90., 30., 1.})
        findings.closing(field, own_cell, par, sun_from(elevation, 20));
    findings.closing(field, own_cell, par, uniform_sky());
}

void leaf_in_the_boundary(Findings& findings) {
    Mesh mesh = leaves_only();
    add_leaf(mesh, {0, 0, .1}, {0, .7, 0}, {0, 0, .4});
    for (const double azimuth : {90., 270.}) {
        const Fractions f = findings.closing(mesh, {.7, .7}, black,
                                             sun_from(45, azimuth), {16384, 8});
        findings.require_agreement(f.leaves, {.4 / .7, 0}, 3e-4,
                                   fmt::format("{} deg", azimuth));
    }
}

void horizontal_leaves(Findings& findings) {
    Mesh mesh = leaves_only();
    add_leaf(mesh, {.8, .9, .4}, {.5, 0, 0}, {0, .4, 0});
    for (const double elevation : {90., 45., 5., .5})
        findings.require_agreement(
            findings
                .closing(mesh, unit_cell, black, sun_from(elevation, 33),
                         {16384, 16})
                .leaves,
            {.2, 0}, 4e-4, fmt::format("{} deg", elevation));
}

void leaves_of_a_millimetre(Findings& findings) {
    const Mesh field =
        in_lattice(two_leaves(1e-3, 1e-4, 90), {1, 1, {.01, .01}, 0});
    const Fractions f =
        findings.closing(field, {.01, .01}, black, uniform_sky(), {16384, 16});
    // Leaves hardly shade each other. They cannot absorb more light than falls
    // on their whole area.
    const double share = f.leaves.mean / (plant_area(field).leaves / 1e-4);
    findings.require(share > .3 && share < 1, ".3 to 1 of the area's light");
    findings.say(fmt::format("{:.2f} of the light on their area", share));
}

void leaves_of_three_metres(Findings& findings) {
    const Mesh field =
        in_lattice(two_leaves(3, .14, 40), {1, 1, {.76, .15}, 0});
    const Fractions f = findings.closing(field, own_cell, par, uniform_sky());
    findings.require(f.leaves.mean > .9, "leaves take more than .9");
    findings.say(fmt::format("leaves absorb {:.3f}", f.leaves.mean));
}

void duplicate_faces(Findings& findings) {
    const Mesh once = load_reference_mesh("maize1");
    Mesh twice = once;
    twice.faces.insert(twice.faces.end(), once.faces.begin(), once.faces.end());
    twice.face_group.insert(twice.face_group.end(), once.face_group.begin(),
                            once.face_group.end());
    const Accuracy accuracy{4096, 16};
    const Fractions one =
        findings.closing(once, own_cell, par, uniform_sky(), accuracy);
    const Fractions two =
        findings.closing(twice, own_cell, par, uniform_sky(), accuracy);
    findings.require_agreement(two.leaves, one.leaves, 1e-3, "leaves");
    findings.require_agreement(two.soil, one.soil, 1e-3, "soil");
}

void faces_without_area(Findings& findings) {
    const Mesh mesh = load_reference_mesh("maize1");
    Mesh more = mesh;
    for (std::uint32_t v = 0; v < 50; ++v) {
        more.faces.push_back({v, v, v, v});
        more.faces.push_back({v, v + 1, v, v + 1});
        more.face_group.insert(more.face_group.end(), {0, 0});
    }
    const auto leaves = [&](const Mesh& m) {
        return findings.closing(m, own_cell, par, uniform_sky()).leaves.mean;
    };
    findings.require(leaves(more) == leaves(mesh), "bit-identical results");
    findings.say("bit-identical");
}

void coincident_leaves(Findings& findings) {
    // A leaf as long as the period ends where its own image begins. A leaf of
    // twice this length coincides with its image everywhere.
    for (const double length : {1., 2.}) {
        Mesh mesh = leaves_only();
        add_leaf(mesh, {.3, .2, .5}, {length, 0, 0}, {0, .25, 0});
        const Fractions f =
            findings.closing(mesh, unit_cell, leaf_optics(.05, .05, 0),
                             sun_from(50, 20), {16384, 16});
        findings.require_agreement(f.leaves, {.25 * .9, 0}, 5e-4, "leaves");
    }
}

void tips_below_the_soil(Findings& findings) {
    Mesh mesh = leaves_only();
    add_leaf(mesh, {.2, .2, -.5}, {.6, 0, 0}, {0, 0, 1});
    const Fractions f = findings.closing(mesh, unit_cell, black,
                                         sun_from(60, 180), {16384, 16});
    findings.require_agreement(f.leaves, {.6 * .5 / std::tan(60 * degree), 0},
                               4e-4, "half above");
    findings.closing(mesh, unit_cell, leaf_optics(.5, .5, 1), uniform_sky());
}

void leaf_on_the_soil(Findings& findings) {
    Mesh mesh = leaves_only();
    add_leaf(mesh, {.2, .2, 0}, {.5, 0, 0}, {0, .5, 0});
    const Fractions f = findings.closing(
        mesh, unit_cell, leaf_optics(.2, .2, .5), uniform_sky(), {4096, 8});
    findings.say(
        fmt::format("leaf {:.4f}, soil {:.4f}", f.leaves.mean, f.soil.mean));
}

void scattering_from_none_to_all(Findings& findings) {
    const Mesh mesh = load_reference_mesh("maize1");
    for (const double rho : {0., .05, .49, .5, .98, 1.})
        for (const double soil : {0., .5, 1.}) {
            const double tau = std::min(rho, 1 - rho);
            const Fractions f =
                findings.closing(mesh, own_cell, leaf_optics(rho, tau, soil),
                                 uniform_sky(), {256, 2});
            const std::string what = fmt::format("{} {} {}", rho, tau, soil);
            findings.require((f.leaves.mean == 0) == (rho + tau == 1), what);
            findings.require((f.soil.mean == 0) == (soil == 1), what);
            if (rho + tau == 1 && soil == 1)
                findings.require(std::abs(f.reflected.mean - 1) < 1e-12, what);
        }
}

}  // namespace

std::vector<ExtremeCase> extreme_surfaces() {
    return {
        {"vertical leaves",
         "nothing from the zenith; from the side area / tan e",
         vertical_leaves},
        {"plant of leaves at 0 deg", "balance", upright_plant},
        {"leaf in the side of the cell", "met from both sides",
         leaf_in_the_boundary},
        {"horizontal leaves", "their area under any sun", horizontal_leaves},
        {"leaves of 1 mm", "0.3 to 1 of the light on their area",
         leaves_of_a_millimetre},
        {"leaves of 3 m", "leaves absorb > 0.9", leaves_of_three_metres},
        {"every face twice", "the same as once", duplicate_faces},
        {"faces without area", "bit-identical results", faces_without_area},
        {"coincident leaves of neighbours", "the same as one",
         coincident_leaves},
        {"leaf tips below the soil", "only the parts above count",
         tips_below_the_soil},
        {"leaf on the soil", "balance", leaf_on_the_soil},
        {"rho + tau 0 to 0.98 and 1, albedo 0, 0.5, 1",
         "0 absorbed if and only if nothing absorbs",
         scattering_from_none_to_all}};
}

}  // namespace ideotype
