// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "ideotype/canopy/quantities.hpp"
#include "ideotype/fidelity/choice.hpp"
#include "temporary_folder.hpp"

namespace ideotype {
namespace {

//! A small field of small plants, quick to measure.
Campaign small() {
    Campaign campaign =
        read_campaign(std::string(IDEOTYPE_CAMPAIGNS) + "/ames_quick.toml");
    campaign.field.rows = campaign.field.plants = 2;
    campaign.tessellation = {8, 6};
    // A bare stalk: without it leaves have more light.
    set_present(campaign.crop.baseline, "sheath", false);
    campaign.sampling = {256, 8};
    return campaign;
}

Trade measured(const Campaign& campaign, std::size_t draws) {
    const Device device(Device::supported_isas().back());
    return measure_trade(campaign, 0, device, {1e9, draws, draws},
                         [](const std::string&, double) {});
}

class Fidelity : public ::testing::Test {
  protected:
    //! Measured once for all tests.
    static const Trade& trade() {
        static const Trade once = measured(small(), 32);
        return once;
    }
};

TEST_F(Fidelity, AReferenceHasNoBias) {
    for (const MeasuredParameter& each : trade().parameters)
        for (const Goal goal : {Goal::value, Goal::difference}) {
            const Estimate bias =
                each.points[each.parameter.reference].of(goal).bias;
            EXPECT_EQ(bias.mean, 0) << each.parameter.name;
            EXPECT_EQ(bias.standard_error, 0) << each.parameter.name;
        }
}

TEST_F(Fidelity, WhatIsOnlyArrangedOtherwiseHasNoBias) {
    for (const MeasuredParameter& each : trade().parameters) {
        if (each.parameter.kind != Parameter::Kind::arrangement &&
            each.parameter.kind != Parameter::Kind::paths)
            continue;
        for (const ParameterPoint& point : each.points)
            for (const Goal goal : {Goal::value, Goal::difference}) {
                const Estimate bias = point.of(goal).bias;
                EXPECT_LE(std::abs(bias.mean), 4 * bias.standard_error)
                    << each.parameter.name << ' ' << point.name;
                EXPECT_LT(bias.standard_error, .01)
                    << each.parameter.name << ' ' << point.name;
            }
    }
}

TEST_F(Fidelity, CoarseLeavesAndMissingOrgansAreFound) {
    const Estimate coarse =
        trade().parameter("cells_along").points.front().of(Goal::value).bias;
    EXPECT_LT(coarse.mean, -3 * coarse.standard_error);
    EXPECT_GT(coarse.mean, -.05);
    const ParameterPoint& bare = trade().parameter("organs").points[1];
    EXPECT_EQ(bare.name, "without stalk");
    EXPECT_GT(bare.of(Goal::value).bias.mean, .03);
    EXPECT_LT(bare.of(Goal::value).bias.standard_error, .01);
}

TEST_F(Fidelity, MorePathsScatterLessAndCostMore) {
    const MeasuredParameter& paths = trade().parameter("paths");
    const ParameterPoint& few = paths.points.front();
    const ParameterPoint& many = paths.points.back();
    EXPECT_GE(few.cost.paths, 64);
    EXPECT_EQ(many.cost.paths, 64 * few.cost.paths);
    // Independent ones would scatter an eighth.
    EXPECT_LT(many.of(Goal::value).scatter.path.mean,
              few.of(Goal::value).scatter.path.mean / 5);
    EXPECT_GT(many.of(Goal::value).scatter.path.mean,
              few.of(Goal::value).scatter.path.mean / 40);
}

TEST_F(Fidelity, NothingOnTheFrontIsBeatenByAnythingElse) {
    for (const Goal goal : {Goal::value, Goal::difference}) {
        const auto front = pareto_front(trade(), goal, Randomness::Fields::one);
        ASSERT_GT(front.size(), 5u);
        for (std::size_t i = 1; i < front.size(); ++i) {
            EXPECT_GE(front[i].seconds(), front[i - 1].seconds());
            EXPECT_LT(front[i].error(), front[i - 1].error());
        }
        std::vector<std::size_t> own;
        for (const MeasuredParameter& each : trade().parameters)
            own.push_back(each.parameter.own);
        const Combination mine =
            combine(trade(), own, {1024, 8}, Randomness::Fields::one, goal);
        bool is_matched = false;
        for (const Combination& each : front)
            is_matched = is_matched || (each.seconds() <= mine.seconds() &&
                                        each.error() <= mine.error());
        EXPECT_TRUE(is_matched);
    }
}

TEST_F(Fidelity, TheCheapestMeetsTheToleranceWhenEvaluatedAgain) {
    constexpr double tolerance = .02;
    const Device device(Device::supported_isas().back());
    for (const auto fields :
         {Randomness::Fields::one, Randomness::Fields::each})
        for (const Goal goal : {Goal::value, Goal::difference}) {
            const auto front = pareto_front(trade(), goal, fields);
            const Combination& found = cheapest(front, tolerance);
            ASSERT_LE(found.error(), tolerance);
            const Check check =
                check_combination(trade(), found, goal, device, .5);
            EXPECT_LT(std::abs(check.bias.mean),
                      tolerance + 3 * check.bias.standard_error);
            EXPECT_LT(check.standard_error.mean,
                      tolerance + 3 * check.standard_error.standard_error);
            EXPECT_LT(check.standard_error.standard_error, tolerance / 3);
        }
}

TEST_F(Fidelity, WhereNoneMeetsTheToleranceTheMostAccurateIsFound) {
    const auto front =
        pareto_front(trade(), Goal::value, Randomness::Fields::one);
    EXPECT_EQ(cheapest(front, 1e-9).error(), front.back().error());
    EXPECT_EQ(cheapest(front, 1).seconds(), front.front().seconds());
}

//! The text of a resolved campaign with other values.
std::string with_keys(std::string text, const std::vector<PastedKey>& keys) {
    for (const PastedKey& key : keys) {
        const auto header = text.find(
            key.section == "[day]" ? "[[day]]" : "[" + key.section + "]");
        const auto line = text.find('\n' + key.name + " = ", header);
        EXPECT_NE(line, std::string::npos) << key.name;
        const auto end = text.find('\n', line + 1);
        text.replace(line + 1, end - line - 1, key.name + " = " + key.value);
    }
    return text;
}

TEST_F(Fidelity, PastedKeysMakeTheChosenCampaign) {
    const auto front =
        pareto_front(trade(), Goal::value, Randomness::Fields::one);
    const Campaign chosen = applied(trade(), front[front.size() / 2]);
    const Campaign pasted =
        parse_campaign(with_keys(small().resolved, keys_of(chosen)), "pasted");
    EXPECT_EQ(pasted.field.rows, chosen.field.rows);
    EXPECT_EQ(pasted.field.plants, chosen.field.plants);
    EXPECT_EQ(pasted.tessellation.cells_along, chosen.tessellation.cells_along);
    EXPECT_EQ(pasted.tessellation.stalk_sides, chosen.tessellation.stalk_sides);
    EXPECT_EQ(pasted.days[0].value.step_minutes,
              chosen.days[0].value.step_minutes);
    EXPECT_EQ(pasted.sampling.paths, chosen.sampling.paths);
    EXPECT_EQ(pasted.sampling.randomisations, chosen.sampling.randomisations);
}

Campaign assimilating(Campaign campaign) {
    campaign.maximised = {"net_assimilation"};
    campaign.photosynthesis = Photosynthesis{};
    return campaign;
}

Parameter named(const std::vector<Parameter>& all, const std::string& name) {
    return *std::find_if(all.begin(), all.end(), [&](const Parameter& each) {
        return each.name == name;
    });
}

//! Of the baseline, relative to another variant with the same draws.
Estimate bias(const Campaign& campaign, const Variant& variant,
              const Variant& reference, std::size_t draws) {
    const Device device(Device::supported_isas().back());
    const Rivals plants = rivals(campaign, cases(campaign).front());
    Probe a(variant, 0, device, plants), b(reference, 0, device, plants);
    std::vector<double> apart;
    while (apart.size() < draws) {
        a.draw();
        b.draw();
        apart.push_back(
            a.means(Goal::value).back() / b.means(Goal::value).back() - 1);
    }
    return estimate(apart);
}

TEST(FidelityOfAssimilation, ControlVolumesAreTradedButNeverChosen) {
    const Campaign campaign = assimilating(small());
    const std::vector<Parameter> all = parameters(campaign, 0);
    const Parameter& pieces = named(all, "pieces");
    EXPECT_EQ(pieces.kind, Parameter::Kind::omission);
    EXPECT_EQ(pieces.values.at(pieces.own).name, "16");  // faces of 8 cells
    EXPECT_EQ(pieces.values.back().name, "96");
    EXPECT_EQ(pieces.at(0).pieces, 12u);
    // Few paths have biases of their own.
    EXPECT_EQ(pieces.base.campaign.sampling.paths,
              16 * named(all, "cells_along").base.campaign.sampling.paths);
    for (const Parameter& each : parameters(small(), 0))
        EXPECT_NE(each.name, "pieces");
    // Light that is taken as even over whole leaves is worth more.
    Variant fine = pieces.at(pieces.reference);
    fine.campaign.sampling.paths = 1 << 15;
    Variant coarse = fine;
    coarse.pieces = 1;
    const Estimate found = bias(campaign, coarse, fine, 12);
    EXPECT_GT(found.mean, 4 * found.standard_error);
    EXPECT_GT(found.mean, 2e-4);
    EXPECT_LT(found.mean, .02);
}

TEST(FidelityOfAssimilation, PathsAreComparedWithManyMore) {
    Campaign campaign = assimilating(small());
    campaign.sampling = {8192, 8};
    const std::vector<Parameter> all = parameters(campaign, 0);
    const Parameter& paths = named(all, "paths");
    EXPECT_TRUE(paths.may_be_biased());
    EXPECT_EQ(paths.values.at(paths.own).name, "8192");
    EXPECT_EQ(paths.values.at(paths.reference).name, "32768");
    EXPECT_EQ(paths.base.randomisations, 8);
    const std::vector<Parameter> of_light = parameters(small(), 0);
    EXPECT_FALSE(named(of_light, "paths").may_be_biased());
}

TEST(FidelityOfAssimilation, WhatFewPathsAreOffByIsPartOfTheBias) {
    const Campaign campaign = assimilating(small());
    const Trade trade = measured(campaign, 3);
    const MeasuredParameter& paths = trade.parameter("paths");
    std::vector<std::size_t> own;
    for (const MeasuredParameter& each : trade.parameters)
        own.push_back(each.parameter.own);
    const auto bias = [&](int number) {
        return combine(trade, own, {number, 8}, Randomness::Fields::one,
                       Goal::value)
            .bias;
    };
    const Estimate many = bias(1 << 14), few = bias(256);
    const Estimate of_few = paths.points.front().of(Goal::value).bias;
    EXPECT_EQ(paths.points.front().name, "256");
    EXPECT_NE(of_few.mean, 0);
    EXPECT_NEAR(few.mean - many.mean, std::abs(of_few.mean), 1e-12);
    EXPECT_GT(few.standard_error, many.standard_error);
    const Device device(Device::supported_isas().back());
    const double net =
        measure_objective(
            "net_assimilation",
            evaluate(request_of(trade.own, 0, trade.rivals[0]), device))
            .estimate.mean;
    EXPECT_NEAR(trade.value.mean, net, .1 * net);
}

TEST(FidelityOfAssimilation, DatesOfASeasonAreTradedForTheObjective) {
    const std::string folder = IDEOTYPE_CAMPAIGNS;
    std::ifstream file(folder + "/bondville.toml");
    std::string text{std::istreambuf_iterator<char>(file), {}};
    const auto replace = [&](const std::string& was, const std::string& is) {
        text.replace(text.find(was), was.size(), is);
    };
    replace("to = 2011-09-20", "to = 2011-07-24");
    replace("\"weather/", '"' + folder + "/weather/");
    replace("\"crops/", '"' + folder + "/crops/");
    const std::string path = temporary_file("fidelity_season.toml");
    std::ofstream(path) << text
                        << "\n[objective]\nmaximise = \"carbon_balance\"\n";
    Campaign campaign = read_campaign(path);
    campaign.tessellation = {8, 6};
    const std::vector<Parameter> all = parameters(campaign, 0);
    const Parameter& dates = named(all, "dates");
    EXPECT_EQ(dates.values.at(dates.own).name, "3");
    const Device device(Device::supported_isas().back());
    const Rivals plants = rivals(campaign, cases(campaign).front());
    Probe probe(dates.at(0), 0, device, plants);
    probe.draw();
    CanopyRequest request = request_of(dates.at(0), 0, plants[0]);
    request.accuracy.randomisations = 4;
    const double carbon =
        measure_objective("carbon_balance", evaluate(request, device))
            .estimate.mean;
    EXPECT_NEAR(probe.means(Goal::value).front(), carbon, .1 * carbon);
    EXPECT_GT(carbon, .1);
    EXPECT_LT(carbon, 3);
}

TEST(FidelityParameters, BlackCanopiesHaveNoScatteringToTrade) {
    Campaign campaign = small();
    campaign.optics = {};
    for (const Parameter& parameter : parameters(campaign, 0))
        EXPECT_NE(parameter.name, "scattering");
}

TEST(FidelityParameters, TheCampaignsOwnValuesAreAmongThem) {
    Campaign campaign = small();
    campaign.tessellation = {13, 7};
    campaign.field.rows = 5;
    campaign.days[0].value.step_minutes = 20;
    for (const Parameter& parameter : parameters(campaign, 0)) {
        if (parameter.kind != Parameter::Kind::fineness) continue;
        Variant own = parameter.base;
        own.campaign = campaign;
        parameter.values[parameter.own].apply(own);
        const auto is = keys_of(own.campaign), was = keys_of(campaign);
        for (std::size_t i = 0; i < is.size(); ++i)
            EXPECT_EQ(is[i].value, was[i].value) << is[i].name;
    }
}

}  // namespace
}  // namespace ideotype
