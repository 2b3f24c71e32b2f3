// SPDX-License-Identifier: Apache-2.0
// Tests plots that stand alone on an infinite plane of soil.
#include <cmath>
#include <numbers>

#include "expectations.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/units.hpp"

namespace ideotype {
namespace {

const Optics black = leaf_optics(0, 0, 0);

//! Results relative to the light that falls on the ground area.
struct Plot {
    Estimate leaves, soil, reflected, incident;
};

Plot trace_plot(const Mesh& mesh, const Optics& optics,
                const Illumination& light, double ground_area = 1,
                Accuracy accuracy = {16384, 16}) {
    const RayScene scene =
        RayScene::isolated(widest_device(), mesh, ground_area);
    const auto tallies =
        simulate(scene, mesh.groups, optics, light, accuracy, {1, 0, 0});
    const auto part = [&](double Budget::*member) {
        std::vector<double> replicates;
        for (const Tally& tally : tallies)
            replicates.push_back(tally.sources[0].*member);
        return estimate(replicates);
    };
    for (const Tally& tally : tallies) {
        const Budget& budget = tally.sources[0];
        EXPECT_NEAR(budget.total(), budget.incident,
                    1e-12 * (1 + budget.incident));
    }
    return {part(&Budget::leaves), part(&Budget::soil),
            part(&Budget::reflected), part(&Budget::incident)};
}

//! Returns a box that stands on the soil without a bottom.
Mesh box(double x, double y, double z) {
    Mesh mesh = leaves_only();
    add_leaf(mesh, {0, 0, z}, {x, 0, 0}, {0, y, 0});
    add_leaf(mesh, {0, 0, 0}, {x, 0, 0}, {0, 0, z});
    add_leaf(mesh, {0, y, 0}, {x, 0, 0}, {0, 0, z});
    add_leaf(mesh, {0, 0, 0}, {0, y, 0}, {0, 0, z});
    add_leaf(mesh, {x, 0, 0}, {0, y, 0}, {0, 0, z});
    return mesh;
}

TEST(Isolated, AHorizontalSheetAbsorbsTheLightOnItsAreaAtAnySunElevation) {
    Mesh mesh = leaves_only();
    add_leaf(mesh, {500, -3, .5}, {.5, 0, 0}, {0, .8, 0});
    for (const double elevation : {90., 40., 5., .1})
        EXPECT_NEAR(
            trace_plot(mesh, black, sun_from(elevation, 33)).leaves.mean, .4,
            1e-4)
            << elevation;
    EXPECT_NEAR(trace_plot(mesh, black, uniform_sky()).leaves.mean, .4, 1e-4);
}

TEST(Isolated, AVerticalSheetTakesItsAreaTimesTheCosine) {
    Mesh mesh = leaves_only();
    add_leaf(mesh, {7, 2, .1}, {0, .5, 0}, {0, 0, 1});
    for (const double elevation : {80., 30., 1.})
        for (const double azimuth : {90., 270., 20.}) {
            const double expected = .5 * std::abs(std::sin(azimuth * degree)) /
                                    std::tan(elevation * degree);
            EXPECT_NEAR(trace_plot(mesh, black, sun_from(elevation, azimuth))
                                .leaves.mean /
                            expected,
                        1, 1e-4)
                << elevation << " " << azimuth;
        }
    // Each side receives light from half of the sky.
    EXPECT_NEAR(trace_plot(mesh, black, uniform_sky()).leaves.mean, .5, 1e-4);
}

TEST(Isolated, AWallSeesTheSkyThatItFaces) {
    // Irradiance of a wall relative to that of the ground under an overcast
    // sky: (1/2 + 4/(3 pi)) / (1 + 4/3), the integral over 1 + 2 cos z.
    Mesh wall = leaves_only();
    add_leaf(wall, {0, 0, 0}, {0, .5, 0}, {0, 0, 1});
    Illumination sky = uniform_sky();
    sky.sources[0].sky = SkySampler({SkyModel::overcast, {}});
    const double expected = (.5 + 4 / (3 * std::numbers::pi)) / (1 + 4. / 3);
    expect_agreement(trace_plot(wall, black, sky).leaves, {expected, 0}, 5e-4,
                     "both sides of half a square metre");

    // Under a clear sky the balance closes, and a level sheet absorbs the light
    // on its area.
    sky.sources[0].sky = SkySampler({SkyModel::clear, {50, 120}});
    Mesh sheet = leaves_only();
    add_leaf(sheet, {0, 0, 1}, {1, 0, 0}, {0, .4, 0});
    EXPECT_NEAR(trace_plot(sheet, black, sky).leaves.mean, .4, 1e-4);
    trace_plot(box(.6, .4, 2), leaf_optics(.4, .4, .3), sky);
}

TEST(Isolated, ABlackBoxAbsorbsTheLightOnItsTopAndWalls) {
    const Mesh mesh = box(.6, .4, 2);
    const Plot sun = trace_plot(mesh, black, sun_from(30, 90), .24);
    const double projected = .24 + .4 * 2 / std::tan(30 * degree);
    EXPECT_NEAR(sun.incident.mean, projected / .24, 1e-9);
    EXPECT_NEAR(sun.leaves.mean, projected / .24, 1e-3);
    const Plot sky = trace_plot(mesh, black, uniform_sky(), .24);
    EXPECT_NEAR(sky.leaves.mean, (.24 + .6 * 2 + .4 * 2) / .24, 1e-3);
}

TEST(Isolated, ASheetHighAboveBrightSoilIsLitFromBelowToo) {
    // The shadow of the sheet reduces the reflected light by less than the
    // fraction (sheet area / height^2).
    Mesh mesh = leaves_only();
    add_leaf(mesh, {0, 0, 50}, {1, 0, 0}, {0, 1, 0});
    for (const Illumination& light : {sun_from(40, 10), uniform_sky()})
        expect_agreement(trace_plot(mesh, leaf_optics(0, 0, .5), light).leaves,
                         {1.5, 0}, 5e-4, "above and below");
}

TEST(Isolated, AWallOnBrightSoilSeesItUpToTheHorizon) {
    // Under a uniform sky the irradiance of each face is 1/2 from the sky plus
    // albedo / 2 from the soil, less the effect of the wall's own shade, which
    // the furnace below tests.
    Mesh mesh = leaves_only();
    add_leaf(mesh, {0, 0, 40}, {0, 1, 0}, {0, 0, 1});
    expect_agreement(
        trace_plot(mesh, leaf_optics(0, 0, .5), uniform_sky()).leaves,
        {1 + .5, 0}, 5e-4, "wall");
}

TEST(Isolated, InTheFurnaceIrradianceIsOneOnBothFacesOfEverything) {
    const double absorptance = 1e-4;
    const Mesh mesh = load_reference_mesh("maize1");
    const Plot plot = trace_plot(
        mesh, leaf_optics(.5 - absorptance / 2, .5 - absorptance / 2, 1),
        uniform_sky(), 1, {65536, 16});
    const double expected = 2 * absorptance * plant_area(mesh).leaves;
    EXPECT_LT(plot.leaves.standard_error, .004 * expected);
    EXPECT_NEAR(plot.leaves.mean / expected, 1,
                4 * plot.leaves.standard_error / expected + 2e-3);
}

TEST(Isolated, ALeafOnTheSoilLetsLightThroughToIt) {
    Mesh mesh = leaves_only();
    add_leaf(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const Plot plot =
        trace_plot(mesh, leaf_optics(.4, .4, .5), sun_from(60, 0));
    expect_agreement(plot.leaves, {.25, 0}, 1e-3, "leaves");
    expect_agreement(plot.soil, {.25, 0}, 1e-3, "soil");
    expect_agreement(plot.reflected, {.5, 0}, 1e-3, "reflected");
}

TEST(Isolated, FiguresReferToTheGroundArea) {
    const Mesh mesh = load_reference_mesh("maize1");
    const Optics par = leaf_optics(.05, .05, .1);
    const Plot one = trace_plot(mesh, par, uniform_sky(), 1, {1024, 4});
    const Plot two = trace_plot(mesh, par, uniform_sky(), 2, {1024, 4});
    EXPECT_NEAR(two.leaves.mean * 2 / one.leaves.mean, 1, 1e-9);
    EXPECT_NEAR(two.soil.mean * 2 / one.soil.mean, 1, 1e-9);
}

TEST(Isolated, APlotOfBlackLeavesUnderAZenithSunEqualsAPeriodicStand) {
    // At this distance no light passes from one plot to another.
    Mesh mesh = load_reference_mesh("maize1");
    const Fractions stand =
        trace(mesh, {10, 10}, black, sun_from(90, 0), {65536, 32});
    const Plot plot = trace_plot(mesh, black, sun_from(90, 0), 100);
    expect_agreement(plot.leaves, stand.leaves, 1e-4, "plot");
}

TEST(Isolated, APlotWithoutFacesTakesNothing) {
    const Plot plot = trace_plot(Mesh{}, black, uniform_sky(), 1, {16, 2});
    EXPECT_EQ(plot.incident.mean, 0);
}

TEST(Isolated, RefusesAGroundAreaThatIsNotPositive) {
    EXPECT_THROW(RayScene::isolated(widest_device(), Mesh{}, 0), Error);
}

}  // namespace
}  // namespace ideotype
