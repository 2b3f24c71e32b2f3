// SPDX-License-Identifier: Apache-2.0
// Tests that the light absorbed by leaves is resolved by origin, face and
// layer, and that the sunlit leaf area is right.
#include <cmath>

#include "expectations.hpp"
#include "extremes.hpp"
#include "ideotype/core/units.hpp"
#include "ideotype/light/report.hpp"
#include "ideotype/light/sunlit.hpp"

namespace ideotype {
namespace {

//! Returns an instant of one second with the given light of sun and sky.
LightSeries instant(SunPosition sun, double beam, double diffuse) {
    return {{{12, 1, sun, {beam, diffuse}}}};
}

DayReport report_of(const Mesh& mesh, GroundPeriod period, const Optics& optics,
                    const LightSeries& day, const Layers& layers = {},
                    const Accuracy& accuracy = {4096, 16}) {
    const RayScene scene(widest_device(), mesh, period.x, period.y);
    const SeriesIllumination light = illuminate(day, SkyModel::uniform, 0);
    DayReport result = report(simulate(scene, mesh.groups, optics, light.light,
                                       accuracy, {1, 0, 0}, layers),
                              light);
    const SunlitReport sunlit = report(
        sunlit_fractions(scene, mesh, light.light, accuracy, {2, 0, 0}), light);
    result.steps[0].sunlit = sunlit.hours[0];
    return result;
}

//! Makes horizontal sheets over the whole period at the given heights, with
//! corners counter-clockwise as seen from above.
Mesh sheets(std::initializer_list<double> heights) {
    Mesh mesh = leaves_only();
    for (const double z : heights)
        add_leaf(mesh, {0, 0, z}, {1, 0, 0}, {0, 1, 0});
    return mesh;
}

TEST(Parts, SunSkyAndScatteredLightAreSeparateAndSumToTheTotal) {
    const double albedo = .5;
    const DayReport r =
        report_of(sheets({1}), {1, 1}, leaf_optics(0, .4, albedo),
                  instant({40, 120}, 3, 1));
    const double incident = 4, absorptance = .6;
    EXPECT_NEAR(r.day.leaves_beam.mean, 3 * absorptance, 1e-2);
    EXPECT_NEAR(r.day.leaves_sky.mean, 1 * absorptance, 1e-2);
    // The soil reflects albedo * 0.4 of the incident light; leaves reflect
    // nothing.
    expect_agreement(r.day.leaves_scattered,
                     {incident * .4 * albedo * absorptance, 0}, 2e-2,
                     "scattered");
    EXPECT_NEAR(r.day.leaves_beam.mean + r.day.leaves_sky.mean +
                    r.day.leaves_scattered.mean,
                r.day.leaves.mean, 1e-12);
}

TEST(Parts, UpperFacesAbsorbSunlightAndLowerFacesLightFromTheSoil) {
    const DayReport r = report_of(sheets({1}), {1, 1}, leaf_optics(0, .4, .5),
                                  instant({40, 120}, 1, 0));
    EXPECT_NEAR(r.adaxial.mean, .6, 1e-2);
    expect_agreement(r.abaxial, {.4 * .5 * .6, 0}, 1e-2, "lower faces");
    EXPECT_NEAR(r.adaxial.mean + r.abaxial.mean, r.day.leaves.mean, 1e-12);
}

TEST(Parts, APlantsLeavesTurnTheirUpperFacesToTheZenith) {
    const DayReport r = report_of(two_leaves(.8, .08, 45), {.76, .15}, black,
                                  instant({0, 0}, 1, 0));
    EXPECT_GT(r.adaxial.mean, .9 * r.day.leaves.mean);
}

TEST(Parts, EachSheetIsInItsLayerAndTheHighestLayerHasNoEnd) {
    const DayReport r =
        report_of(sheets({.1, .3, 5}), {1, 1}, leaf_optics(0, .5, 0),
                  instant({0, 0}, 1, 0), {.25, 3});
    ASSERT_EQ(r.layers.size(), 3u);
    expect_agreement(r.layers[2], {.5, 0}, 1e-2, "top");
    expect_agreement(r.layers[1], {.25, 0}, 1e-2, "middle");
    expect_agreement(r.layers[0], {.125, 0}, 1e-2, "bottom");
}

TEST(Parts, OfTwoSheetsTheUpperOneIsSunlit) {
    const DayReport r =
        report_of(sheets({.4, .8}), {1, 1}, black, instant({70, 200}, 1, 1));
    expect_agreement(*r.steps[0].sunlit, {.5, 0}, 1e-3, "sunlit");
}

TEST(Parts, LeafAreaBelowTheSoilIsShaded) {
    Mesh mesh = leaves_only();
    add_leaf(mesh, {0, .5, -1}, {.5, 0, 0}, {0, 0, 4});
    const DayReport r =
        report_of(mesh, {10, 10}, black, instant({60, 180}, 1, 0));
    expect_agreement(*r.steps[0].sunlit, {.75, 0}, 1e-3, "sunlit");
}

TEST(Parts, SunlitAreaOfRandomHorizontalLeavesFollowsBeer) {
    // The sunlit leaf area index is (1 - exp(-L)) for any sun: Monsi and Saeki
    // 1953 (doi:10.1093/aob/mci052 in English).
    const Mesh mesh = load_reference_mesh("poisson_horizontal_L3");
    for (const double zenith : {0., 60.}) {
        const DayReport r =
            report_of(mesh, {1, 1}, black, instant({zenith, 77}, 1, 0));
        // All light absorbed by black leaves falls on sunlit area.
        const double lai = plant_area(mesh).leaves;
        const Estimate sunlit = *r.steps[0].sunlit;
        expect_agreement(
            sunlit,
            {r.day.leaves.mean / lai, r.day.leaves.standard_error / lai}, 3e-3,
            "sunlit");
        EXPECT_NEAR(sunlit.mean, (1 - std::exp(-lai)) / lai, .003);
    }
}

TEST(Parts, WithoutASunNothingIsSunlit) {
    const DayReport r =
        report_of(sheets({1}), {1, 1}, black, instant({0, 0}, 0, 1));
    EXPECT_EQ(r.steps[0].sunlit->mean, 0);
}

TEST(Parts, AHitOfALeafThatIsEdgeOnToTheSunStandsForALimitedArea) {
    Mesh mesh = leaves_only();
    add_leaf(mesh, {.5, 0, 0}, {0, 1, 0}, {0, 0, 1});
    const RayScene scene(widest_device(), mesh, 1, 1);
    const Illumination sun = sun_from(45, 0);
    Tally tally;
    tally.resolution = std::make_shared<const Resolution>(Resolution{{1e-3}});
    LeafLight hit;
    hit.beam = {{0, 1e-9}};
    tally.leaf_light = {hit};
    const double fraction = sunlit_fractions({tally}, scene, mesh.groups, {},
                                             sun, plant_area(mesh).leaves)
                                .fractions[0][0];
    EXPECT_TRUE(std::isfinite(fraction));
    EXPECT_LT(fraction, 1e-5);
}

TEST(Parts, APlotIsSunlitWhereverItStands) {
    Mesh mesh = leaves_only();
    add_leaf(mesh, {500, -30, 1}, {1, 0, 0}, {0, 1, 0});
    add_leaf(mesh, {500, -30, .5}, {1, 0, 0}, {0, 1, 0});
    const RayScene plot = RayScene::isolated(widest_device(), mesh, 1);
    // The lower sheet is displaced by half its width, out of the shade.
    const SunlitFractions sunlit =
        sunlit_fractions(plot, mesh, sun_from(45, 90), {4096, 2}, {1, 0, 0});
    EXPECT_NEAR(sunlit.fractions[0][0], .75, 2e-3);
}

}  // namespace
}  // namespace ideotype
