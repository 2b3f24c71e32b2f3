// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "extremes.hpp"
#include "ideotype/light/device.hpp"
#include "ideotype/light/report.hpp"
#include "one_band.hpp"
#include "setups.hpp"

namespace ideotype {
namespace {

//! A level leaf over a part of each square metre of black soil, under an
//! inclined beam and a sky.
class LitLeaf : public ::testing::Test {
  protected:
    static Mesh leaf(double side) {
        Mesh mesh;
        mesh.vertices = {
            {0, 0, 1}, {side, 0, 1}, {side, side, 1}, {0, side, 1}};
        mesh.faces = {{0, 1, 2, 3}};
        mesh.groups = {{"leaf01"}};
        mesh.face_group = {0};
        return mesh;
    }

    Simulation found(double tolerance, std::uint64_t seed = 1, double side = .7,
                     const Optics& optics = {}) const {
        const Mesh mesh = leaf(side);
        return simulate_to_tolerance(RayScene(device, mesh, 1, 1), mesh.groups,
                                     optics, light, {most_paths, 16, tolerance},
                                     {seed, 0, 0});
    }

    //! Relative errors of the light, over 200 seeds.
    struct Errors {
        double spread, reported, largest;
    };
    Errors errors(double tolerance, double side, const Optics& optics) const {
        constexpr std::uint64_t seeds = 200;
        std::vector<double> means;
        double reported = 0, largest = 0;
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            const Simulation one = found(tolerance, seed, side, optics);
            EXPECT_FALSE(one.is_capped);
            const Estimate x = absorbed_by_leaves(one.tallies.front());
            means.push_back(x.mean);
            reported += x.standard_error * x.standard_error / seeds;
            largest = std::max(largest, x.standard_error);
        }
        const Estimate all = estimate(means);
        return {all.standard_error * std::sqrt(seeds) / all.mean,
                std::sqrt(reported) / all.mean, largest / all.mean};
    }

    static Estimate leaves(const Simulation& simulation) {
        std::vector<double> all;
        for (const Tally& tally : simulation.tallies.front())
            all.push_back(tally.groups[0]);
        return estimate(all);
    }

    static constexpr int most_paths = 1 << 16;
    const Device device{Device::supported_isas().back()};
    const Illumination light{
        {{glm::dvec3{.6, 0, -.8}, 700, {}}, {std::nullopt, 300, {}}}};
};

TEST_F(LitLeaf, IsMetWithAsManyPathsAsThatTakes) {
    const Simulation rough = found(1e-2), fine = found(1e-3);
    EXPECT_LT(2 * rough.paths, fine.paths);
    EXPECT_FALSE(fine.is_capped);
    // The standard error from 16 randomisations is accurate to about 20 %.
    EXPECT_LE(leaves(rough).standard_error, 1.6e-2 * leaves(rough).mean);
    EXPECT_LE(leaves(fine).standard_error, 1.6e-3 * leaves(fine).mean);
    EXPECT_NEAR(leaves(fine).mean, 490, 4 * leaves(fine).standard_error);
}

TEST_F(LitLeaf, HasTheSameLightFromTheSamePathsWithoutATolerance) {
    const Simulation adaptive = found(2e-3);
    const Mesh mesh = leaf(.7);
    const std::vector<Tally> tallies =
        simulate(RayScene(device, mesh, 1, 1), mesh.groups, {}, light,
                 adaptive.work, 16, {1, 0, 0});
    ASSERT_EQ(adaptive.tallies.front().size(), tallies.size());
    for (std::size_t i = 0; i < tallies.size(); ++i)
        EXPECT_EQ(adaptive.tallies.front()[i].groups, tallies[i].groups);
}

TEST_F(LitLeaf, SaysWhenTheMostPathsAreTooFew) {
    const Simulation capped = found(1e-6);
    EXPECT_TRUE(capped.is_capped);
    EXPECT_EQ(capped.paths, most_paths);
    EXPECT_GT(leaves(capped).standard_error, 1e-6 * leaves(capped).mean);
}

//! Stopping as soon as the estimated error is small would select errors that
//! are too small.
TEST_F(LitLeaf, ReportsTheErrorsThatItMakes) {
    double made = 0, reported = 0;
    constexpr int runs = 400;
    for (int seed = 1; seed <= runs; ++seed) {
        const Estimate x =
            leaves(found(4e-3, static_cast<std::uint64_t>(seed)));
        made += (x.mean - 490) * (x.mean - 490);
        reported += x.standard_error * x.standard_error;
    }
    // The root mean square of 400 errors is accurate to 3.5 %.
    EXPECT_NEAR(std::sqrt(made / reported), 1, .12);
}

TEST_F(LitLeaf, DoesNotTakeALeafThatNoPathMeetsForCertain) {
    // The side of the leaf is 0.02 mm: 1 / 2,500 million of the ground.
    const Simulation rare = found(1e-2, 1, 2e-5);
    EXPECT_EQ(rare.paths, most_paths);
    EXPECT_TRUE(rare.is_capped);
    EXPECT_EQ(leaves(rare).mean, 0);
    EXPECT_NEAR(absorbed_by_leaves(rare.tallies.front()).standard_error,
                1000. / (16. * most_paths), 1e-3);
}

//! A trial that hits such a leaf by chance, or that finds no light scattered to
//! it by the soil, must not lead to far too few paths.
TEST_F(LitLeaf, IsMetOftenEnoughWhereLeavesAreFew) {
    Optics optics;
    optics.materials = {{.05, .05}};
    optics.soil_albedo = .2;
    constexpr double tolerance = .05;
    const Errors found = errors(tolerance, .06, optics);
    // The spread over 200 seeds is accurate to 5 %.
    EXPECT_NEAR(found.reported / found.spread, 1, .15);
    EXPECT_LT(found.spread, 1.3 * tolerance);
    EXPECT_LT(found.largest, 2.5 * tolerance);
}

//! This leaf absorbs little of each path, so that one path more or less says
//! little about the error.
TEST_F(LitLeaf, ReportsTheErrorsOfALeafThatIsNearlyWhite) {
    Optics optics;
    optics.materials = {{.499, .499}};
    optics.soil_albedo = .2;
    const Errors found = errors(1e-2, .7, optics);
    EXPECT_NEAR(found.reported / found.spread, 1, .15);
}

TEST_F(LitLeaf, IsCertainWhereItCannotAbsorb) {
    const Mesh mesh = leaf(.7);
    Optics white;
    white.materials = {{.4, .6}};
    const Simulation found =
        simulate_to_tolerance(RayScene(device, mesh, 1, 1), mesh.groups, white,
                              light, {most_paths, 16, 1e-3}, {1, 0, 0});
    EXPECT_FALSE(found.is_capped);
    EXPECT_LE(found.paths, 64);
    EXPECT_EQ(absorbed_by_leaves(found.tallies.front()).standard_error, 0);
}

//! Rows of maize as in campaigns. The number of paths is neither too small nor
//! twice as large as necessary, as it was when paths were doubled until the
//! error was met.
TEST(Tolerance, IsCloseToTheResultingError) {
    const Mesh mesh = load_reference_mesh("maize1");
    const RayScene scene(widest_device(), mesh, own_cell.x, own_cell.y);
    constexpr double tolerance = 4e-3;
    std::vector<double> relative;
    double made = 0;
    constexpr int runs = 300;
    const double truth =
        absorbed_by_leaves(simulate(scene, mesh.groups, par, sun_from(40, 160),
                                    {1 << 15, 32}, {1, 0, 0}))
            .mean;
    for (int seed = 2; seed < 2 + runs; ++seed) {
        const Simulation found = simulate_to_tolerance(
            scene, mesh.groups, par, sun_from(40, 160),
            {1 << 16, 16, tolerance}, {static_cast<std::uint64_t>(seed), 0, 0});
        const Estimate x = absorbed_by_leaves(found.tallies.front());
        relative.push_back(x.standard_error / x.mean / tolerance);
        made += std::pow(x.mean / truth - 1, 2) / runs;
    }
    std::nth_element(relative.begin(), relative.begin() + runs / 2,
                     relative.end());
    EXPECT_GT(relative[runs / 2], .88);
    EXPECT_LT(relative[runs / 2], 1.02);
    // The error is accurate to 4 %; in a few runs the trial was too short.
    EXPECT_LT(std::sqrt(made), 1.15 * tolerance);
}

TEST_F(LitLeaf, HasNothingToTraceInTheDark) {
    const Mesh mesh = leaf(.7);
    const Simulation dark =
        simulate_to_tolerance(RayScene(device, mesh, 1, 1), mesh.groups, {}, {},
                              {most_paths, 16, 1e-3}, {1, 0, 0});
    EXPECT_FALSE(dark.is_capped);
    EXPECT_EQ(leaves(dark).mean, 0);
}

}  // namespace
}  // namespace ideotype
