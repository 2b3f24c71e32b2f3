// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "expectations.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype {
namespace {

TEST(Energy, ShiftingThePeriodsChangesNothingBeyondTheError) {
    const Mesh mesh = load_reference_mesh("maize1");
    Mesh moved = mesh;
    for (glm::dvec3& v : moved.vertices)
        v = {v.x + 10000.3, v.y - 5000.07, v.z};
    const auto of = [](const Mesh& m) {
        return trace(m, {0.76, 0.15}, leaf_optics(.05, .05, .1),
                     sun_from(40, 20))
            .leaves;
    };
    expect_agreement(of(moved), of(mesh), 3e-4, "moved by 10 km");
}

TEST(Energy, AStandWithoutLeavesIsItsSoil) {
    const Fractions f = trace(Mesh{}, {1, 1}, leaf_optics(.05, .05, .25),
                              uniform_sky(), {4096, 8});
    EXPECT_NEAR(f.soil.mean, .75, 4 * f.soil.standard_error + 1e-12);
    EXPECT_NEAR(f.reflected.mean, .25, 4 * f.soil.standard_error + 1e-12);
}

TEST(Energy, ALeafOnTheSoilLetsLightThroughToIt) {
    Mesh mesh = leaves_only();
    add_sheet(mesh, {1, 1}, 0, 0);
    // The leaf transmits 0.4; the soil reflects half of this to the leaf, which
    // transmits 0.4 of it again, and so on.
    const Fractions f = trace(mesh, {1, 1}, leaf_optics(.4, .4, .5),
                              sun_from(60, 0), {1 << 14, 16});
    expect_agreement(f.leaves, {.25, 0}, 1e-3, "leaves");
    expect_agreement(f.soil, {.25, 0}, 1e-3, "soil");
    expect_agreement(f.reflected, {.5, 0}, 1e-3, "reflected");
}

TEST(Energy, EverySourceKeepsItsOwnEnergy) {
    Illumination light = sun_from(30, 10);
    light.sources[0].energy = 3;
    light.sources.push_back(
        {std::nullopt, 0.004, SkySampler({SkyModel::overcast, {}})});
    light.sources.push_back({sun_from(60, 90).sources[0].direction, 2, {}});
    light.sources.push_back(
        {std::nullopt, 1, SkySampler({SkyModel::clear, {70, 180}})});
    const Mesh mesh = load_reference_mesh("maize1");
    const RayScene scene(widest_device(), mesh, 0.76, 0.15);
    for (const Tally& tally : simulate(
             scene, mesh.groups, leaf_optics(.4, .4, .1), light, {128, 3}, {}))
        for (std::size_t s = 0; s < 4; ++s)
            EXPECT_NEAR(tally.sources[s].total() / light.sources[s].energy, 1,
                        1e-12);
}

TEST(Energy, SameSeedSameBitsOtherSeedOtherBits) {
    const Mesh mesh = load_reference_mesh("maize1");
    const auto absorbed = [&](std::uint64_t seed) {
        return trace(mesh, {0.76, 0.15}, leaf_optics(.05, .05, .1),
                     uniform_sky(), {512, 4}, seed)
            .leaves.mean;
    };
    EXPECT_EQ(absorbed(7), absorbed(7));
    EXPECT_NE(absorbed(7), absorbed(8));
}

TEST(Energy, StandardErrorIsThatOfTheSpread) {
    // The spread of many independent estimates must agree with the standard
    // error that each of them reports.
    const Mesh mesh = load_reference_mesh("maize1");
    std::vector<double> means;
    double variance = 0;
    constexpr int runs = 200;
    for (int run = 0; run < runs; ++run) {
        const Estimate e =
            trace(mesh, {0.76, 0.15}, leaf_optics(.05, .05, .1), uniform_sky(),
                  {256, 8}, static_cast<std::uint64_t>(100 + run))
                .leaves;
        means.push_back(e.mean);
        variance += e.standard_error * e.standard_error / runs;
    }
    const double spread = estimate(means).standard_error * std::sqrt(runs);
    // The ratio of two such estimates is accurate to about 6 %.
    EXPECT_NEAR(spread / std::sqrt(variance), 1, 0.2);
}

TEST(Energy, RefusesWrongNumbersOfPaths) {
    const Mesh mesh = load_reference_mesh("sheets1");
    const RayScene scene(widest_device(), mesh, 1, 1);
    Illumination two = uniform_sky();
    two.sources.push_back(two.sources[0]);
    const Optics optics;
    EXPECT_THROW(simulate(scene, mesh.groups, optics, two, {1, 2}, {}), Error);
}

}  // namespace
}  // namespace ideotype
