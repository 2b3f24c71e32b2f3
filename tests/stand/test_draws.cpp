// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ideotype/light/device.hpp"
#include "spec/problems.hpp"
#include "stand/stand.hpp"

namespace ideotype {
namespace {

const std::string path = std::string(IDEOTYPE_CAMPAIGNS) + "/ames_quick.toml";

using Texts = std::vector<std::string>;

const Texts quick{"objective={maximise=\"net_assimilation\"}",
                  "light.tolerance=0", "light.paths=64", "field.rows=1",
                  "field.plants=2"};

//! Returns a small campaign with other settings.
Campaign small(Texts settings) {
    settings.insert(settings.begin(), quick.begin(), quick.end());
    return read_campaign(path, settings);
}

//! Draws of a capacity and a reflectance, with other settings.
Campaign drawn(const std::string& across = "\"mean\"") {
    return small({"objective.over=[\"draw\"]", "objective.scenarios=" + across,
                  "draw=[{name=\"low\", keys=[\"photosynthesis.rate_2000\", "
                  "\"optics.leaf_reflectance\"], values=[40, 0.1]}, "
                  "{name=\"high\", keys=[\"photosynthesis.rate_2000\", "
                  "\"optics.leaf_reflectance\"], values=[60, 0.05]}, "
                  "{name=\"middle\", keys=[\"photosynthesis.rate_2000\", "
                  "\"optics.leaf_reflectance\"], values=[50, 0.05]}]"});
}

Outcome baseline_outcome(const Campaign& campaign) {
    const Case chosen = cases(campaign)[0];
    Stand stand(campaign, chosen);
    const Device device(Device::supported_isas().back());
    return stand.evaluate({campaign.crop.baseline},
                          sampling_of({}, campaign, chosen), device);
}

std::vector<double> by_scenario(const Campaign& campaign) {
    const QuantitySet measured =
        AcrossScenarios(campaign, cases(campaign)[0]).measured();
    const std::size_t first = measured.offset("net_assimilation_by_scenario");
    const Outcome outcome = baseline_outcome(campaign);
    std::vector<double> values;
    for (std::size_t i = 0; i < 3; ++i)
        values.push_back(outcome.quantities.at(first + i).mean);
    return values;
}

TEST(Draws, EachIsTheCampaignWithItsValuesBitForBit) {
    const std::vector<double> values = by_scenario(drawn());
    const std::vector<std::pair<int, double>> drawn_values{
        {40, 0.1}, {60, 0.05}, {50, 0.05}};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto [rate, reflectance] = drawn_values[i];
        const Campaign alone =
            small({fmt::format("photosynthesis.rate_2000={}", rate),
                   fmt::format("optics.leaf_reflectance={}", reflectance)});
        EXPECT_EQ(values[i], baseline_outcome(alone).objectives[0].mean) << i;
    }
    EXPECT_LT(values[0], values[2]);
    EXPECT_LT(values[2], values[1]);
}

TEST(Draws, TheObjectiveIsTheMeanTheWorstOrAQuantileOfTheDraws) {
    const std::vector<double> values = by_scenario(drawn());
    const auto objective = [](const std::string& across) {
        return baseline_outcome(drawn(across)).objectives[0].mean;
    };
    EXPECT_NEAR(objective("\"mean\""), average(values), 1e-12);
    EXPECT_EQ(objective("\"worst\""), values[0]);
    Campaign quantile = drawn("\"quantile\"");
    for (const auto& [part, expected] :
         {std::pair(0.1, values[0]), {0.5, values[2]}, {1., values[1]}}) {
        quantile.spec.objective.tail = part;
        EXPECT_EQ(baseline_outcome(quantile).objectives[0].mean, expected);
    }
}

//! Draws of photosynthesis and grain share their light.
TEST(Draws, OfGrowingPlantsEqualSeparateEvaluationsBitForBit) {
    const Texts season{
        "objective={maximise=\"grain_yield\", over=[\"climate\"]}",
        "light.tolerance=0",
        "light.paths=64",
        "light.stages=3",
        "field.rows=1",
        "field.plants=2",
        "light.fields=4",
        "final.randomisations=4"};
    const auto growing = [&](Texts settings) {
        settings.insert(settings.begin(), season.begin(), season.end());
        return read_campaign(
            std::string(IDEOTYPE_CAMPAIGNS) + "/growing_season.toml", settings);
    };
    const Campaign draws = growing(
        {"objective.over=[\"draw\"]",
         "draw=[{name=\"a\", "
         "keys=[\"photosynthesis.vmax\", \"plant.baseline.grain.kernels\"], "
         "values=[30, 400]}, {name=\"b\", "
         "keys=[\"photosynthesis.vmax\", \"plant.baseline.grain.kernels\"], "
         "values=[45, 500]}]"});
    EXPECT_FALSE(draws_change_light(draws.spec));
    EXPECT_TRUE(draws_change_light(drawn().spec));
    const Case chosen = cases(draws)[0];
    const QuantitySet measured = AcrossScenarios(draws, chosen).measured();
    const Outcome together = baseline_outcome(draws);
    const std::size_t first = measured.offset("grain_yield_by_scenario");
    const Campaign plain = growing({"objective.over=[]"});
    const std::vector<KeyFactor> keys = factors_of(
        {{"photosynthesis.vmax", "plant.baseline.grain.kernels"}, {}});
    for (const auto& [index, values] :
         {std::pair<std::size_t, std::vector<double>>{0, {30, 400}},
          {1, {45, 500}}})
        EXPECT_EQ(together.quantities[first + index].mean,
                  baseline_outcome(with_keys(plain, keys, values))
                      .objectives[0]
                      .mean);
}

TEST(Draws, OfTheCapacityReplaceTheRateInFullLight) {
    const Campaign rate = small({});
    EXPECT_FALSE(rate.spec.plant.crop.photosynthesis.rate_2000.empty());
    const Campaign draws =
        small({"objective.over=[\"draw\"]",
               "draw=[{name=\"a\", keys=[\"photosynthesis.amax\"], "
               "values=[45]}]"});
    EXPECT_EQ(baseline_outcome(draws).objectives[0].mean,
              baseline_outcome(small({"photosynthesis={amax=45}"}))
                  .objectives[0]
                  .mean);
}

TEST(Draws, AllFaultsAreReported) {
    const auto faults = [](const std::string& draw, const std::string& over) {
        try {
            small({"draw=[" + draw + "]", "objective.over=" + over});
        } catch (const InputError& error) {
            std::string text;
            for (const Problem& each : error.problems()) text += each.what;
            return text;
        }
        return std::string();
    };
    const std::string good =
        "{name=\"a\", keys=[\"photosynthesis.rd\"], values=[1.5]}";
    EXPECT_EQ(faults(good, "[\"draw\"]"), "");
    EXPECT_NE(faults(good, "[]").find("add \"draw\" to objective.over"),
              std::string::npos);
    EXPECT_NE(faults("", "[\"draw\"]").find("has no [[draw]]"),
              std::string::npos);
    const std::string wrong = faults(
        "{name=\"a\", keys=[\"photosynthesis.rd\", \"optics.none\"], "
        "values=[-5, 1]}, {name=\"b\", keys=[\"photosynthesis.rd\"], "
        "values=[1, 2]}",
        "[\"draw\"]");
    for (const char* const part :
         {"draw.values has 2 numbers (there are 1 keys)",
          "draw.keys has \"optics.none\" (which is not a variable key",
          "photosynthesis.rd is -5"})
        EXPECT_NE(wrong.find(part), std::string::npos) << part << "\n" << wrong;
    EXPECT_NE(faults("{name=\"a\", keys=[\"optics.leaf_reflectance\"], "
                     "values=[0.99]}",
                     "[\"draw\"]")
                  .find("with these values"),
              std::string::npos);
}

}  // namespace
}  // namespace ideotype
