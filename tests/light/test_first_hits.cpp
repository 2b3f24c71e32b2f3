// SPDX-License-Identifier: Apache-2.0
// Tests depth buffers of beams against rays, and the lattices of their points.
#include <cmath>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "beams/beam_lattice.hpp"
#include "beams/directions.hpp"
#include "extremes.hpp"
#include "first_hits_referee.hpp"
#include "ideotype/light/sunlit.hpp"
#include "one_band.hpp"

namespace ideotype {
namespace {

TEST(FirstHits, AreThoseOfRays) {
    for (const FirstHitsCompared& mesh : compare_first_hits(300)) {
        EXPECT_GT(mesh.points, 5000u) << mesh.name;
        EXPECT_EQ(mesh.wrong, 0u) << mesh.name;
        // In the ray tracer's single precision, the edges of faces are at
        // slightly different positions.
        EXPECT_LT(static_cast<double>(mesh.differ),
                  2e-3 * static_cast<double>(mesh.points))
            << mesh.name;
    }
}

TEST(BeamLattice, RepeatsWithTheCell) {
    const glm::dvec3 direction = *sun_from(40, 70).sources[0].direction;
    for (const std::int64_t points : {1, 2, 50, 4096})
        for (const int lanes : {1, 8, 16}) {
            const BeamLattice lattice =
                beam_lattice(1.52, .3, points, lanes, direction);
            EXPECT_GE(lattice.points(), points);
            EXPECT_LE(lattice.fine, lanes);
            EXPECT_EQ(std::gcd(lattice.points(), std::int64_t{36}), 1);
            // Each step leads to the pixel with the stated number.
            for (const auto& [step, number] :
                 {std::pair{lattice.step_u, lattice.number_u},
                  std::pair{lattice.step_v, lattice.number_v}}) {
                const glm::dvec2 off =
                    step - static_cast<double>(number) * lattice.step_one;
                for (const double periods : {off.x / 1.52, off.y / .3})
                    EXPECT_NEAR(periods, std::round(periods), 1e-9);
            }
            // The area of a pixel is its share of the cell.
            EXPECT_NEAR((lattice.step_u.x * lattice.step_v.y -
                         lattice.step_u.y * lattice.step_v.x) *
                            static_cast<double>(lattice.pixels),
                        1.52 * .3, 1e-9);
        }
}

//! Returns the light of a level leaf under beams of one sun, with the given
//! number of first hits.
Estimate leaf_light(std::uint32_t first_hits, int randomisations,
                    const Optics& optics = {}) {
    Mesh mesh = leaves_only();
    add_leaf(mesh, {.8, .9, .4}, {.5, 0, 0}, {0, .4, 0});
    const RayScene scene(widest_device(), mesh, 1, 1);
    Workload work;
    work.first_hits = {first_hits};
    std::vector<double> leaves;
    for (const Tally& tally :
         simulate(scene, mesh.groups, optics, sun_from(35, 20), work,
                  randomisations, {1, 0, 0})) {
        EXPECT_NEAR(tally.sources[0].total(), 1, 1e-12);
        EXPECT_EQ(tally.rays, 0u);
        leaves.push_back(tally.leaves());
    }
    return estimate(leaves);
}

TEST(FirstHits, AreDrawnWithoutBiasForAnyNumberOfRandomisations) {
    for (const int randomisations : {2, 3, 4, 7, 16, 40}) {
        const Estimate leaves = leaf_light(256, randomisations);
        // A few randomisations may agree by chance, so that the tolerance is at
        // least two points of each randomisation.
        const double point = 2. / 256 / std::sqrt(randomisations);
        EXPECT_NEAR(leaves.mean, .2, 4 * std::max(leaves.standard_error, point))
            << randomisations;
    }
}

TEST(FirstHits, ErrorsFallFasterThanThoseOfIndependentPoints) {
    const double few = leaf_light(128, 256).standard_error;
    const double many = leaf_light(8192, 256).standard_error;
    EXPECT_LT(few, std::sqrt(.2 * .8 / 128 / 256));
    // With 64 times as many points, the error of independent points would be an
    // eighth.
    EXPECT_LT(many, few / 12);
}

TEST(FirstHits, ARandomisationIsTheSameHoweverManyFollow) {
    Mesh mesh = leaves_only();
    add_leaf(mesh, {.8, .9, .4}, {.5, .1, .1}, {0, .4, 0});
    const RayScene scene(widest_device(), mesh, 1, 1);
    const auto first = [&](int randomisations) {
        Workload work;
        work.first_hits = {1000};
        return simulate(scene, mesh.groups, par, sun_from(35, 20), work,
                        randomisations, {1, 0, 0})
            .front()
            .groups;
    };
    EXPECT_EQ(first(16), first(40));
}

//! In all engines, only the first of several faces with the same corners
//! receives light.
TEST(Coincident, OnlyTheFirstFaceIsLit) {
    Mesh mesh = leaves_only();
    mesh.groups.push_back({"again"});
    add_leaf(mesh, {0, 0, .5}, {1, 0, 0}, {0, 1, 0});
    mesh.faces.push_back({3, 2, 1, 0});
    mesh.face_group = {0, 1};
    const RayScene scene(widest_device(), mesh, 1, 1);
    EXPECT_EQ(scene.surfaces().faces.size(), 1u);
    for (const Illumination& light : {sun_from(40, 10), uniform_sky()}) {
        const Fractions f =
            trace(mesh, {1, 1}, leaf_optics(0, 0, 0), light, {256, 4});
        EXPECT_NEAR(f.groups[0].mean, 1, 1e-12);
        EXPECT_EQ(f.groups[1].mean, 0);
    }
    // The hidden face is half of the leaf area.
    const SunlitFractions sunlit =
        sunlit_fractions(scene, mesh, sun_from(40, 10), {1024, 2}, {1, 0, 0});
    EXPECT_NEAR(sunlit.fractions[0][0], .5, 1e-2);
}

//! Partly coincident faces, and faces that coincide with their own images, act
//! as one surface for beams, skies and the sunlit area.
TEST(Coincident, FacesOnEachOtherAreOneSurface) {
    for (const double slope : {0., .3}) {
        Mesh one = leaves_only(), two = one, wrapped = one;
        const auto add = [slope](Mesh& mesh, double x, double length) {
            add_leaf(mesh, {x, .2, .3 + slope * x}, {length, 0, slope * length},
                     {0, .5, 0});
        };
        add(one, .1, .7);
        add(two, .1, .5);
        add(two, .4, .4);
        const Illumination sun = sun_from(70, 0);
        const auto sunlit_of = [&](const Mesh& mesh) {
            const RayScene scene(widest_device(), mesh, 1, 1);
            return sunlit_fractions(scene, mesh, sun, {4096, 4}, {1, 0, 0})
                .fractions[0][0];
        };
        EXPECT_NEAR(sunlit_of(one), 1, 1e-12);
        EXPECT_NEAR(sunlit_of(two), .7 / .9, 2e-3);
        for (const Illumination& light : {sun, uniform_sky()}) {
            const auto leaves = [&](const Mesh& mesh) {
                return trace(mesh, {1, 1}, leaf_optics(.1, .2, 0), light,
                             {16384, 8})
                    .leaves;
            };
            const Estimate a = leaves(one), b = leaves(two);
            EXPECT_NEAR(a.mean, b.mean,
                        5 * std::hypot(a.standard_error, b.standard_error));
            EXPECT_LT(a.standard_error, 2e-3 * a.mean);
        }
        if (slope > 0) continue;
        add(wrapped, .3, 2);
        EXPECT_NEAR(sunlit_of(wrapped), .5, 1e-12);
    }
}

}  // namespace
}  // namespace ideotype
