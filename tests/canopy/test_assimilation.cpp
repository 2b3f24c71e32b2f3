// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <fstream>
#include <optional>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "field_of_two_leaves.hpp"
#include "ideotype/canopy/assimilation.hpp"
#include "ideotype/canopy/canopy.hpp"
#include "ideotype/light/device.hpp"
#include "ideotype/light/transport.hpp"
#include "leaf_places.hpp"

namespace ideotype {
namespace {

class Assimilating : public FieldOfTwoLeaves {
  protected:
    //! Returns the daily gross assimilation [mol m-2].
    Estimate gross(const Accuracy& accuracy, std::uint64_t seed) const {
        std::vector<double> values;
        const FluxTallies fluxes =
            assimilate(light(request.scene.bands[0], accuracy, seed), pieces,
                       lit())
                .tallies;
        for (const FluxTally& tally : fluxes.front())
            values.push_back(tally.sum());
        return estimate(values);
    }
};

//! With few paths, places have many parts; with one tally, each has one piece.
TEST_F(Assimilating, PlacesKeepTheAreaAndTheHeightOfTheirPieces) {
    double all = 0, mean_height = 0;
    for (std::size_t v = 0; v < pieces.count; ++v) {
        all += pieces.area[v] / scene->ground_area();
        mean_height += pieces.area[v] / scene->ground_area() * pieces.height[v];
    }
    std::size_t before = 0;
    for (const Accuracy& accuracy :
         {Accuracy{128, 16}, Accuracy{8192, 16}, Accuracy{8192, 1}}) {
        const LeafPlaces places(pieces, lit(),
                                light(request.scene.bands[0], accuracy, 1));
        EXPECT_GT(places.count(), before);
        before = places.count();
        double area = 0, of_parts = 0, height = 0;
        for (std::size_t p = 0; p < places.count(); ++p) {
            double shares = 0;
            places.for_parts(p, [&](std::size_t j, double at, double share) {
                shares += share;
                of_parts += places.part_index[j];
                height += places.part_index[j] * at;
            });
            EXPECT_NEAR(shares, 1, 1e-12);
            area += places.index[p];
        }
        EXPECT_NEAR(area, all, 1e-12 * all);
        EXPECT_NEAR(of_parts, all, 1e-12 * all);
        EXPECT_NEAR(height, mean_height, 1e-12 * mean_height);
        for (std::size_t v = 0; v < pieces.count; ++v) {
            ASSERT_GE(places.part[v], places.first_part[places.of[v]]);
            ASSERT_LT(places.part[v], places.first_part[places.of[v] + 1]);
        }
    }
    EXPECT_EQ(before, pieces.count);
}

//! See tests/benchmark/README.md for larger fields and more paths.
TEST_F(Assimilating, FewPathsDoNotBiasAssimilation) {
    request.details.exact = true;
    request.accuracy = {1 << 20, 16, 1e-3};
    const Estimate exact = evaluate(request, device).assimilation->gross.sum;
    EXPECT_LT(exact.standard_error, 1.5e-3 * exact.mean);

    constexpr int runs = 1000;
    std::vector<double> found;
    double variance = 0;
    int beyond = 0;  // runs that deviate by more than two standard errors
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

//! Makes leaves of two triangles each, which shade each other.
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

//! Without smaller pieces than whole faces, assimilation would be 1 % too high.
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

//! Each component assimilates according to its own model.
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
    EXPECT_NEAR(found[0].loss.in_light / found[1].loss.in_light,
                dark_respiration(FarquharLeaf{}, 30) /
                    dark_respiration(CollatzLeaf{}, 30),
                1e-9);
    // Under equal light the C4 leaf assimilates more than the C3 leaf.
    EXPECT_GT(found[1].gross.mean, 1.05 * found[0].gross.mean);
}

TEST_F(TwoLeaves, PartsOfAssimilationSumToTheWhole) {
    request.scene.components[0].photosynthesis.emplace();
    for (const auto fields : {Fields::one, Fields::each}) {
        const CanopyReport report = evaluated(fields);
        const AssimilationReport& all = *report.assimilation;
        ASSERT_EQ(all.gross.tallies.size(), 8u);
        double leaves = 0, layers = 0, hours = 0;
        for (const Estimate& leaf : all.gross.groups) leaves += leaf.mean;
        for (const Estimate& layer : all.gross.layers) layers += layer.mean;
        const auto& steps = request.scene.bands[0].light.series.steps;
        for (std::size_t i = 0; i < steps.size(); ++i)
            hours += 1e-6 * steps[i].seconds * all.gross.hours[i].mean;
        EXPECT_GT(all.gross.sum.mean, .1);
        EXPECT_NEAR(leaves / all.gross.sum.mean, 1, 1e-12);
        EXPECT_NEAR(layers / all.gross.sum.mean, 1, 1e-12);
        EXPECT_NEAR(hours / all.gross.sum.mean, 1, 1e-12);
        EXPECT_LT(sum_of(all.losses).all(), all.gross.sum.mean);
        EXPECT_GT(sum_of(all.losses).all(), sum_of(all.losses).in_light);
    }
}

TEST_F(TwoLeaves, AssimilationOfDaysAndHoursSumsToThatOfTheMeanDay) {
    request.scene.components[0].photosynthesis.emplace();
    request.scene.bands[0].light = illuminate(
        clear_days({"ames", 42, -93.6, -5},
                   {{{2025, 7, 7}, {2025, 8, 7}, {2025, 9, 20}}, 7, 20, 60},
                   .45),
        SkyModel::uniform, 90, Skies::shared, 2);
    const AssimilationReport all = *evaluated().assimilation;
    const LightSeries& series = request.scene.bands[0].light.series;
    ASSERT_EQ(all.gross.dates.size(), 3u);
    double days = 0, hours = 0;
    for (const Estimate& date : all.gross.dates) days += date.mean / 3;
    const auto steps = series.steps_of_hours();
    for (std::size_t h = 0; h < steps.size(); ++h)
        hours += 1e-6 * series.steps[steps[h].front()].seconds *
                 all.gross.hours[h].mean;
    EXPECT_NEAR(days / all.gross.sum.mean, 1, 1e-12);
    EXPECT_NEAR(hours / all.gross.sum.mean, 1, 1e-12);
    EXPECT_GT(all.gross.dates[0].mean, all.gross.dates[2].mean);
}

//! Returns a horizontal black leaf that covers the ground, under each of the
//! given time steps.
CanopyRequest black_sheet(const std::vector<TimeStep>& steps) {
    CanopyRequest request = two_leaves({64, 8});
    Scene& scene = request.scene;
    scene.components = {{.name = "sheet",
                         .mesh = {{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                                  {{0, 1, 2, 3}},
                                  {0},
                                  {{"leaf01", {0, 0, 1}}}}}};
    scene.cell = {Boundary::periodic, 1, 1, 1};
    scene.photons = 1;
    request.scene.bands[0].light = illuminate({steps}, SkyModel::uniform, 90);
    scene.bands[0].optics = {};
    Photosynthesis& leaves =
        request.scene.components[0].photosynthesis.emplace();
    leaves.rates = {CollatzLeaf{}};
    leaves.profile = CapacityProfile::none;
    request.details.pieces = 1;
    return request;
}

TEST(BlackSheet, AssimilatesAsCollatzSaysInEachInstantsAir) {
    std::ifstream file(IDEOTYPE_TEST_DATA "/physiology/collatz.json");
    const nlohmann::json values = nlohmann::json::parse(file).at("fixed_ci");
    const Device device(Device::supported_isas().back());
    for (const bool is_beam : {true, false}) {
        std::vector<TimeStep> steps;
        double respired = 0;
        for (const nlohmann::json& each : values) {
            TimeStep step;
            step.hour = static_cast<double>(steps.size());
            step.seconds = 3600;
            step.sun = {40, 120};
            (is_beam ? step.par.beam : step.par.diffuse) = each.at("Q");
            step.temperature = each.at("T");
            step.humidity = each.at("vpd_rh");
            respired += 3600e-6 * each.at("Rd").get<double>();
            steps.push_back(step);
        }
        const AssimilationReport report =
            *evaluate(black_sheet(steps), device).assimilation;
        for (std::size_t i = 0; i < values.size(); ++i)
            EXPECT_NEAR(report.gross.hours.at(i).mean, values[i].at("gross"),
                        1e-6)
                << i;
        EXPECT_NEAR(sum_of(report.losses).in_light, respired, 1e-12);
    }
}

TEST_F(TwoLeaves, LightDoesNotDependOnWhetherLeavesAssimilate) {
    const CanopyReport dark = evaluated();
    request.scene.components[0].photosynthesis.emplace();
    const CanopyReport report = evaluated();
    EXPECT_EQ(report.par().budget_by_randomisation,
              dark.par().budget_by_randomisation);
    ASSERT_EQ(report.groups.size(), dark.groups.size());
    for (std::size_t g = 0; g < dark.groups.size(); ++g) {
        EXPECT_NEAR(report.par().light.groups[g].mean,
                    dark.par().light.groups[g].mean,
                    1e-9 * dark.par().light.day.incident);
        EXPECT_EQ(report.groups[g].name, dark.groups[g].name);
    }
}

//! Plants vary, so that pieces at the same position of two plants differ too.
TEST_F(TwoLeaves, PiecesOfPlantsThatDifferAssimilateAsExactly) {
    request.scene.components[0].variation = {.15,  .15,  {15}, {20}, .1,
                                             {20}, {30}, {86}, .3,   .3};
    request.scene.components[0].photosynthesis.emplace();
    request.accuracy = {1 << 14, 16};
    const CanopyReport report = evaluated();
    request.details.exact = true;
    request.accuracy = {1 << 20, 16, 1e-3};
    const CanopyReport exact = evaluated();
    EXPECT_EQ(report.lai, exact.lai);
    EXPECT_LT(exact.assimilation->gross.sum.standard_error,
              1.5e-3 * exact.assimilation->gross.sum.mean);
    EXPECT_NEAR(report.assimilation->gross.sum.mean /
                    exact.assimilation->gross.sum.mean,
                1, .005);
}

TEST_F(TwoLeaves, AssimilationIsConcaveInLight) {
    request.scene.components[0].photosynthesis.emplace();
    const CanopyReport report = evaluated();
    const double linear = .06 * 4.57e-6 * report.par().light.day.leaves.mean;
    EXPECT_LT(report.assimilation->gross.sum.mean, .8 * linear);
    request.scene.components[0].photosynthesis->rates = {
        HyperbolaLeaf{{.06, 1, 1e9}, {}}};
    EXPECT_NEAR(evaluated().assimilation->gross.sum.mean / linear, 1, 1e-9);
}

}  // namespace
}  // namespace ideotype
