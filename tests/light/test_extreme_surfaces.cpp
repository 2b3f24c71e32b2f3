// Surfaces at the limits of what can be asked for. In every
// case all figures are finite and the balance closes to rounding.
#include "extremes.hpp"
#include "ideotype/core/units.hpp"

namespace ideotype {
namespace {

TEST(ExtremeSurfaces, VerticalLeavesTakeNothingFromTheZenith) {
    Mesh mesh = leaves_only();
    add_leaf(mesh, {.3, .2, .1}, {0, .5, 0}, {0, 0, 1});
    add_leaf(mesh, {.1, .7, .1}, {.8, 0, 0}, {0, 0, 1});
    const Fractions zenith =
        closing(mesh, {1, 1}, leaf_optics(0, 0, 0), sun_from(90, 0));
    EXPECT_EQ(zenith.leaves.mean, 0);
    // From the side: area x horizontal over vertical component.
    const Fractions side = closing(mesh, {1, 1}, leaf_optics(0, 0, 0),
                                   sun_from(80, 90), {16384, 16});
    expect_agreement(side.leaves, {.5 * std::tan(10 * degree), 0}, 3e-4,
                     "side");
}

TEST(ExtremeSurfaces, ALeafInTheBoundaryOfTheCellIsMetFromBothSides) {
    Mesh mesh = leaves_only();
    add_leaf(mesh, {0, 0, .1}, {0, .7, 0}, {0, 0, .4});
    for (const double azimuth : {90., 270.}) {
        const Fractions f = closing(mesh, {.7, .7}, leaf_optics(0, 0, 0),
                                    sun_from(45, azimuth), {16384, 8});
        expect_agreement(f.leaves, {.4 / .7, 0}, 3e-4, "boundary");
    }
}

TEST(ExtremeSurfaces, HorizontalLeavesTakeTheirAreaWhateverTheSun) {
    Mesh mesh = leaves_only();
    add_leaf(mesh, {.8, .9, .4}, {.5, 0, 0}, {0, .4, 0});
    for (const double elevation : {90., 45., 5., .5})
        expect_agreement(closing(mesh, {1, 1}, leaf_optics(0, 0, 0),
                                 sun_from(elevation, 33), {16384, 16})
                             .leaves,
                         {.2, 0}, 4e-4, std::to_string(elevation));
}

TEST(ExtremeSurfaces, LeavesOfAMillimetreTakeTheLightOfTheirArea) {
    const Mesh plant = two_leaves(1e-3, 1e-4, 90);
    const Field field = build_field(plant, {1, 1, {.01, .01}, 0, 0}, {0});
    const Fractions f = closing(field.mesh, {.01, .01}, leaf_optics(0, 0, 0),
                                uniform_sky(), {16384, 16});
    // At most both faces of all area; the leaves hardly shade each other.
    const double lai = leaf_area(field.mesh) / 1e-4;
    EXPECT_GT(f.leaves.mean, .3 * lai);
    EXPECT_LT(f.leaves.mean, lai);
}

TEST(ExtremeSurfaces, LeavesOfThreeMetresSpanManyCells) {
    const Mesh plant = two_leaves(3, .14, 40);
    const Field field = build_field(plant, {1, 1, {.76, .15}, 90, 0}, {0});
    const Fractions f = closing(field.mesh, {.76, .15}, par, uniform_sky());
    EXPECT_GT(f.leaves.mean, .9);
}

TEST(ExtremeSurfaces, DuplicateFacesActAsOne) {
    Mesh once = load_reference_mesh("maize1");
    Mesh twice = once;
    twice.faces.insert(twice.faces.end(), once.faces.begin(), once.faces.end());
    twice.face_group.insert(twice.face_group.end(), once.face_group.begin(),
                            once.face_group.end());
    const Sampling sampling{4096, 16};
    const Fractions one = closing(once, own_cell, par, uniform_sky(), sampling);
    const Fractions two =
        closing(twice, own_cell, par, uniform_sky(), sampling);
    expect_agreement(two.leaves, one.leaves, 1e-3, "leaves");
    expect_agreement(two.soil, one.soil, 1e-3, "soil");
}

TEST(ExtremeSurfaces, FacesWithoutAreaChangeNothing) {
    const Mesh mesh = load_reference_mesh("maize1");
    Mesh more = mesh;
    for (std::uint32_t v = 0; v < 50; ++v) {
        more.faces.push_back({v, v, v, v});
        more.faces.push_back({v, v + 1, v, v + 1});
        more.face_group.insert(more.face_group.end(), {0, 0});
    }
    EXPECT_EQ(closing(more, own_cell, par, uniform_sky()).leaves.mean,
              closing(mesh, own_cell, par, uniform_sky()).leaves.mean);
}

TEST(ExtremeSurfaces, CoincidentLeavesOfNeighboursActAsOne) {
    // Each leaf is as long as a period: it ends where its own image begins,
    // and one of twice the length lies on its image throughout.
    for (const double length : {1., 2.}) {
        Mesh mesh = leaves_only();
        add_leaf(mesh, {.3, .2, .5}, {length, 0, 0}, {0, .25, 0});
        const Fractions f = closing(mesh, {1, 1}, leaf_optics(.05, .05, 0),
                                    sun_from(50, 20), {16384, 16});
        expect_agreement(f.leaves, {.25 * .9, 0}, 5e-4, "leaves");
    }
}

TEST(ExtremeSurfaces, LeafTipsBelowTheSoilAreInTheDark) {
    Mesh mesh = leaves_only();
    add_leaf(mesh, {.2, .2, -.5}, {.6, 0, 0}, {0, 0, 1});
    const Fractions f = closing(mesh, {1, 1}, leaf_optics(0, 0, 0),
                                sun_from(60, 180), {16384, 16});
    expect_agreement(f.leaves, {.6 * .5 / std::tan(60 * degree), 0}, 4e-4,
                     "half above");
    closing(mesh, {1, 1}, leaf_optics(.5, .5, 1), uniform_sky());
}

TEST(ExtremeSurfaces, ScatteringFromNoneToAllClosesTheBalance) {
    const Mesh mesh = load_reference_mesh("maize1");
    for (const double rho : {0., .05, .49, .5, .98, 1.})
        for (const double soil : {0., .5, 1.}) {
            const double tau = std::min(rho, 1 - rho);
            const Fractions f =
                closing(mesh, own_cell, leaf_optics(rho, tau, soil),
                        uniform_sky(), {256, 2});
            EXPECT_EQ(f.leaves.mean == 0, rho + tau == 1);
            EXPECT_EQ(f.soil.mean == 0, soil == 1);
            if (rho + tau == 1 && soil == 1) {
                EXPECT_NEAR(f.reflected.mean, 1, 1e-12);
            }
        }
}

}  // namespace
}  // namespace ideotype
