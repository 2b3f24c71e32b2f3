// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "ideotype/canopy/assimilation.hpp"
#include "ideotype/canopy/canopy.hpp"
#include "ideotype/light/device.hpp"
#include "ideotype/light/transport.hpp"
#include "two_leaves.hpp"

namespace ideotype {
namespace {

//! Plants of two leaves that are turned at random, in one field.
class FieldOfTwoLeaves : public ::testing::Test {
  protected:
    FieldOfTwoLeaves() {
        Component& component = request.scene.components[0];
        component.jitter = 45;
        component.photosynthesis.emplace();
        const Pieces plant = cut_leaves(component.mesh);
        Field field = draw_field(request.scene, {1}, {&plant.mesh, 1});
        pieces = pieces_of_field({&plant, 1}, field);
        field.mesh = pieces.mesh;
        scene.emplace(build_scene(device, field));
        std::vector<double> index(plant.uncut_groups);
        for (std::size_t v = 0; v < pieces.count; ++v)
            index[pieces.group[v]] += pieces.area[v] / field.cell.ground_area;
        leaves = leaf_groups(request.scene, component.mesh.groups, index);
    }

    //! Gross assimilation of a day [mol m-2].
    Estimate gross(const Accuracy& accuracy, std::uint64_t seed) const {
        const Band& par = request.scene.bands[0];
        std::vector<double> values;
        for (const AssimilationTally& tally : assimilate(
                 simulate(*scene, pieces.mesh.groups, par.optics,
                          par.light.light, accuracy, {seed}, {}, pieces.count),
                 pieces,
                 {*scene, pieces.mesh.groups, par, request.scene.photons,
                  leaves, layers}))
            values.push_back(tally.gross());
        return estimate(values);
    }

    const Device device{Device::supported_isas().back()};
    const Layers layers;
    CanopyRequest request = two_leaves({});
    Pieces pieces;
    std::optional<RayScene> scene;
    std::vector<LeafGroup> leaves;
};

//! See tests/benchmark/README.md for larger fields and more paths.
TEST_F(FieldOfTwoLeaves, FewPathsDoNotBiasAssimilation) {
    request.details.exact = true;
    request.accuracy = {1 << 20, 16, 1e-3};
    const Estimate exact = evaluate(request, device).assimilation->gross;
    EXPECT_LT(exact.standard_error, 1.5e-3 * exact.mean);

    constexpr int runs = 1000;
    std::vector<double> found;
    double variance = 0;
    int beyond = 0;  // by two standard errors
    for (int seed = 1; seed <= runs; ++seed) {
        const Estimate one = gross({128, 16}, static_cast<std::uint64_t>(seed));
        found.push_back(one.mean);
        variance += one.standard_error * one.standard_error / runs;
        beyond += std::abs(one.mean - exact.mean) > 2 * one.standard_error;
    }
    const Estimate mean = estimate(found);
    EXPECT_NEAR(mean.mean, exact.mean,
                3 * std::hypot(mean.standard_error, exact.standard_error) +
                    1e-3 * exact.mean);
    EXPECT_LT(mean.standard_error, 2e-3 * mean.mean);
    EXPECT_NEAR(mean.standard_error * std::sqrt(runs / variance), 1, .12);
    EXPECT_LT(beyond, .09 * runs);
}

}  // namespace
}  // namespace ideotype
