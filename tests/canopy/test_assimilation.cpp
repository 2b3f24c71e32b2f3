// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "field_of_two_leaves.hpp"
#include "ideotype/canopy/assimilation.hpp"
#include "ideotype/canopy/canopy.hpp"
#include "ideotype/light/device.hpp"
#include "ideotype/light/transport.hpp"

namespace ideotype {
namespace {

class Assimilating : public FieldOfTwoLeaves {
  protected:
    //! Returns the gross assimilation of a day [mol m-2].
    Estimate gross(const Accuracy& accuracy, std::uint64_t seed) const {
        std::vector<double> values;
        const FluxTallies fluxes = assimilate(
            light(request.scene.bands[0], accuracy, seed), pieces, lit());
        for (const FluxTally& tally : fluxes.front())
            values.push_back(tally.sum());
        return estimate(values);
    }
};

//! See tests/benchmark/README.md for larger fields and more paths.
TEST_F(Assimilating, FewPathsDoNotBiasAssimilation) {
    request.details.exact = true;
    request.accuracy = {1 << 20, 16, 1e-3};
    const Estimate exact = evaluate(request, device).assimilation->gross.sum;
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

//! Leaves of two triangles each, in the shade of each other.
Mesh small_leaves() {
    Mesh mesh;
    mesh.groups = {{"leaf01", {0, 0, 1}}};
    constexpr double radian = 3.14159265358979 / 180;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 2; ++j) {
            const double azimuth = (75 * i + 150 * j) * radian;
            const double rise = (10 - 8 * i) * radian;
            const glm::dvec3 along(std::sin(azimuth) * std::cos(rise),
                                   std::cos(azimuth) * std::cos(rise),
                                   std::sin(rise));
            const glm::dvec3 across(std::cos(azimuth), -std::sin(azimuth), 0);
            const glm::dvec3 base(.01 * i - .015, .012 * j, .06 + .04 * i);
            const auto v = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.insert(
                mesh.vertices.end(),
                {base, base + .055 * along + .04 * across, base + .11 * along,
                 base + .055 * along - .04 * across});
            mesh.faces.push_back({v, v + 1, v + 2, v + 2});
            mesh.faces.push_back({v, v + 2, v + 3, v + 3});
        }
    mesh.face_group.assign(mesh.faces.size(), 0);
    return mesh;
}

//! Pieces as large as the faces would assimilate 1 % too much.
TEST(SmallLeaves, AssimilateAsTheirPointsDo) {
    const Device device(Device::supported_isas().back());
    CanopyRequest request = two_leaves({1 << 20, 16, 3e-4});
    Scene& scene = request.scene;
    scene.components = {{.name = "leaves", .mesh = small_leaves()}};
    scene.cell = {Boundary::periodic, .12, .12, .12 * .12};
    scene.bands[0].light = illuminate(
        clear_days({"ames", 42, -93.6, -5}, {{{2025, 8, 7}}, 10, 11, 60}, .45),
        SkyModel::uniform, 0);
    scene.bands[0].optics = {PlantOptics{{.06, .1}, {}, {}}.materials(), .1};
    Photosynthesis& leaves = scene.components[0].photosynthesis.emplace();
    leaves.rates = {HyperbolaLeaf{{.052, .8, 32}}};
    leaves.profile = CapacityProfile::none;
    const Estimate found = evaluate(request, device).assimilation->gross.sum;
    request.details.exact = true;
    request.accuracy.tolerance = 1e-3;
    const Estimate exact = evaluate(request, device).assimilation->gross.sum;
    const double error = std::hypot(found.standard_error, exact.standard_error);
    EXPECT_LT(error, 1.5e-3 * exact.mean);
    EXPECT_NEAR(found.mean, exact.mean, 3 * error + 1e-3 * exact.mean);
}

//! Each by the model of its own component.
TEST(SmallLeaves, OfC3AmongC4AssimilateAsTheirPointsDo) {
    const Device device(Device::supported_isas().back());
    CanopyRequest request = two_leaves({1 << 20, 16, 3e-4});
    Scene& scene = request.scene;
    Mesh beside = small_leaves();
    for (glm::dvec3& vertex : beside.vertices) vertex.x += .12;
    scene.components = {{.name = "soybean", .mesh = small_leaves()},
                        {.name = "maize", .mesh = beside}};
    scene.cell = {Boundary::periodic, .24, .12, .24 * .12};
    const LeafRates rates[] = {FarquharLeaf{}, CollatzLeaf{}};
    for (std::size_t c = 0; c < 2; ++c) {
        Photosynthesis& leaves = scene.components[c].photosynthesis.emplace();
        leaves.rates = {rates[c]};
        leaves.profile = CapacityProfile::none;
    }
    const auto assimilation = [&] {
        const CanopyReport report = evaluate(request, device);
        return by_component(*report.assimilation, report.groups, 2);
    };
    const auto found = assimilation();
    request.details.exact = true;
    request.accuracy.tolerance = 1.5e-3;
    const auto exact = assimilation();
    for (std::size_t c = 0; c < 2; ++c) {
        const double mean = exact[c].gross.mean;
        const double error = std::hypot(found[c].gross.standard_error,
                                        exact[c].gross.standard_error);
        EXPECT_GT(mean, .1);
        EXPECT_LT(error, 3e-3 * mean);
        EXPECT_NEAR(found[c].gross.mean, mean, 3 * error + 1e-3 * mean);
    }
    EXPECT_NEAR(found[0].respiration.in_light / found[1].respiration.in_light,
                dark_respiration(FarquharLeaf{}, 30) /
                    dark_respiration(CollatzLeaf{}, 30),
                1e-9);
    // In light of the same strength the C4 leaf assimilates more.
    EXPECT_GT(found[1].gross.mean, 1.05 * found[0].gross.mean);
}

}  // namespace
}  // namespace ideotype
