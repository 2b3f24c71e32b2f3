// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "season_numbers.hpp"

namespace ideotype {
namespace {

//! Returns a campaign of a hot week at Bondville, with maize that assimilates
//! according to Collatz.
Campaign week(const std::string& water,
              std::vector<std::string> settings = {}) {
    settings.insert(settings.begin(),
                    {"climate.from=2011-07-21", "climate.to=2011-07-28",
                     "light.tolerance=0", "light.paths=1024", "field.rows=2",
                     "field.plants=2", "objective.maximise=net_assimilation",
                     "replicates=1"});
    std::string text =
        read_campaign(std::string(IDEOTYPE_CAMPAIGNS) + "/bondville.toml")
            .source;
    const std::size_t second = text.find("[[spacing]]\nname = \"15x6\"");
    text.erase(second, text.find("[plant]") - second);
    text += "\n[photosynthesis]\nmodel = \"collatz\"\n" + water;
    return read_campaign_text(
        text, std::string(IDEOTYPE_CAMPAIGNS) + "/week.toml", settings);
}

const std::string balance = "[water]\n";

TEST(Water, LeavesAtAirTemperatureAssimilateAsWithoutWaterBitForBit) {
    const auto before = numbers(week(""));
    const auto with = numbers(week("[water]\nleaf_temperature = false\n"));
    EXPECT_GT(before.size(), 100u);
    for (const auto& [name, number] : before)
        EXPECT_EQ(with.at(name), number) << name;
    EXPECT_GT(with.at("transpiration_0"), 2);
    EXPECT_EQ(with.at("leaf_warming_0"), 0);
}

//! Leaves without enzymes only respire, at their own temperature.
TEST(Water, GrossAssimilationIsBeforeRespiration) {
    const Campaign idle = week(balance, {"photosynthesis.vmax=0"});
    const Outcome outcome = season_of(idle);
    const OutcomeSchema schema =
        outcome_schema(idle, cases(idle).at(0), idle.sampling);
    const auto number = [&](const char* name) {
        return find(schema, outcome, name).value();
    };
    const Estimate gross = number("gross_assimilation"),
                   net = number("net_assimilation"),
                   balance_of_carbon = number("carbon_balance"),
                   respiration = number("respiration");
    // The temperatures of solved points are accurate to about 0.003 K.
    EXPECT_LT(std::abs(gross.mean), 1e-4 * std::abs(net.mean));
    EXPECT_LT(net.mean, 0);
    EXPECT_GT(respiration.standard_error, 0);
    // Dark respiration is computed at air temperature.
    EXPECT_GT(respiration.mean, -net.mean);
    EXPECT_LT(balance_of_carbon.mean, -respiration.mean);
    const auto as_air = numbers(
        week("[water]\nleaf_temperature = false\n", {"photosynthesis.vmax=0"}));
    EXPECT_EQ(as_air.at("gross_assimilation_0"), 0);
    EXPECT_GT(std::abs(as_air.at("respiration_0") / respiration.mean - 1),
              1e-3);
}

TEST(Water, PartsOfGrossAssimilationSumUp) {
    const auto values = numbers(week(balance));
    const auto plain = numbers(week("[water]\nleaf_temperature = false\n"));
    double leaves = 0, organs = 0, layers = 0;
    for (const auto& [name, number] : values) {
        if (name.starts_with("assimilation_by_leaf")) leaves += number;
        if (name.starts_with("assimilation_by_organ")) organs += number;
        if (name.starts_with("assimilation_by_layer")) layers += number;
    }
    const double gross = values.at("gross_assimilation_0");
    EXPECT_NEAR(leaves, values.at("assimilation_by_organ_0"), 1e-9);
    EXPECT_NEAR(organs, gross, 1e-9);
    EXPECT_NEAR(layers, gross, 1e-9);
    const double at_night = plain.at("net_assimilation_0") -
                            plain.at("gross_assimilation_0") +
                            plain.at("respiration_0");
    EXPECT_NEAR(gross - values.at("net_assimilation_0"),
                values.at("respiration_0") - at_night, 1e-9);
}

//! The tested ranges are those of maize in the field during a hot week.
TEST(Water, TranspirationOfMaizeIsRealistic) {
    const auto values = numbers(week(balance));
    EXPECT_GT(values.at("transpiration_0"), 3);
    EXPECT_LT(values.at("transpiration_0"), 6);
    EXPECT_GT(values.at("water_use_efficiency_0"), 3);
    EXPECT_LT(values.at("water_use_efficiency_0"), 6);
    EXPECT_GT(values.at("leaf_warming_0"), -1.5);
    EXPECT_LT(values.at("leaf_warming_0"), 2);
    EXPECT_NEAR(values.at("water_use_0"), 8 * values.at("transpiration_0"),
                1e-9);
    double leaves = 0, layers = 0, days = 0;
    for (const auto& [name, number] : values) {
        if (name.starts_with("transpiration_by_leaf")) leaves += number;
        if (name.starts_with("transpiration_by_layer")) layers += number;
        if (name.starts_with("transpiration_by_day")) days += number / 8;
    }
    EXPECT_NEAR(leaves, values.at("transpiration_0"), 1e-9);
    EXPECT_NEAR(layers, values.at("transpiration_0"), 1e-9);
    EXPECT_NEAR(days, values.at("transpiration_0"), 1e-9);
}

TEST(Water, ReportsEstimatedAirVariables) {
    const auto estimated = [](const Campaign& campaign) {
        return light_of(campaign, cases(campaign).at(0)).estimated;
    };
    EXPECT_EQ(
        estimated(week(balance)),
        (std::vector<std::string>{"wind", "pressure", "longwave radiation"}));
    EXPECT_TRUE(estimated(week("")).empty());
}

TEST(Water, UseFollowsTheAirAndTheStomata) {
    const auto now = numbers(week(balance, {"climate.co2=372"}));
    const auto rich = numbers(week(balance, {"climate.co2=550"}));
    EXPECT_LT(rich.at("transpiration_0"), .95 * now.at("transpiration_0"));
    EXPECT_LT(rich.at("canopy_conductance_0"),
              .8 * now.at("canopy_conductance_0"));
    EXPECT_GT(rich.at("leaf_warming_0"), now.at("leaf_warming_0") + .1);
    EXPECT_NEAR(rich.at("net_assimilation_0") / now.at("net_assimilation_0"), 1,
                .03);
    const auto open = numbers(week(balance + "slope = 2.5\n"));
    const auto usual = numbers(week(balance));
    EXPECT_GT(open.at("transpiration_0"), usual.at("transpiration_0"));
    EXPECT_LT(open.at("leaf_warming_0"), usual.at("leaf_warming_0"));
    // The air within the canopy becomes moist, which reduces transpiration.
    const auto above = numbers(week(balance + "canopy_air = false\n"));
    EXPECT_GT(above.at("transpiration_0"), usual.at("transpiration_0"));
    // Leaves become hot if their stomata are nearly closed.
    const auto closed =
        numbers(week(balance + "slope = 0.01\nintercept = 0.001\n"));
    EXPECT_GT(closed.at("hot_hours_0"), 5);
    EXPECT_LT(usual.at("hot_hours_0"), 3);
}

TEST(Water, IsWithinALimitByTwoStandardErrors) {
    const Campaign dry = week(balance + "limit = 10\n");
    const Outcome outcome = season_of(dry);
    const OutcomeSchema schema =
        outcome_schema(dry, cases(dry).at(0), dry.sampling);
    const Estimate water = find(schema, outcome, "water_use").value();
    EXPECT_GT(water.standard_error, 0);
    const double largest = water.mean + 2 * water.standard_error;
    EXPECT_NEAR(outcome.violation, largest / 10 - 1, 1e-9);
    const auto violation_at = [](double limit) {
        return season_of(week(fmt::format("{}limit = {}\n", balance, limit)))
            .violation;
    };
    EXPECT_GT(violation_at(water.mean + water.standard_error), 0);
    EXPECT_EQ(violation_at(1.0001 * largest), 0);
}

TEST(Water, NeedsLeavesThatDependOnCo2) {
    try {
        week(balance, {"photosynthesis.model=hyperbola"});
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("does not depend on CO2"),
                  std::string::npos)
            << error.what();
    }
    EXPECT_THROW(week("", {"objective.maximise=water_use_efficiency"}), Error);
}

}  // namespace
}  // namespace ideotype
