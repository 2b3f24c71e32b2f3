// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "stand/stand.hpp"

namespace ideotype {
namespace {

//! Returns ames_quick with additional lines before the first [[day]] and below
//! [objective].
Campaign changed(const std::string& before_day, const std::string& objective) {
    std::string text =
        read_campaign(std::string(IDEOTYPE_CAMPAIGNS) + "/ames_quick.toml")
            .resolved;
    const auto insert = [&](const std::string& more, const std::string& at,
                            std::size_t offset) {
        text.insert(text.find(at) + offset, more);
    };
    insert(before_day, "[[day]]", 0);
    insert(objective, "[objective]\n", 12);
    return parse_campaign(text, "changed.toml");
}

constexpr auto south =
    "[[site]]\nname = \"south\"\nlatitude = 25\nlongitude = -100\n"
    "utc_offset = -6\n";
constexpr auto narrow =
    "[[spacing]]\nname = \"narrow\"\nrow = 0.381\nplant = 0.1524\n"
    "row_direction = 90\n";

Campaign over_sites(const std::string& how) {
    return changed(south, "over = [\"site\"]\nscenarios = \"" + how + "\"\n");
}

Outcome evaluated(const Campaign& campaign, const Task& task = {}) {
    const Case chosen = cases(campaign).at(task.case_index);
    return Stand(campaign, chosen)
        .evaluate({campaign.crop.baseline}, sampling_of(task, campaign, chosen),
                  Device(Device::supported_isas().back()));
}

//! Returns the outcomes of one plant in a separate case for each site, with the
//! random numbers of the given case.
std::vector<Outcome> separately(const Case& robust) {
    const Campaign campaign = changed(south, "");
    const Device device(Device::supported_isas().back());
    std::vector<Outcome> outcomes;
    for (Case one : cases(campaign)) {
        one.seed = robust.seed;
        outcomes.push_back(Stand(campaign, one)
                               .evaluate({campaign.crop.baseline},
                                         sampling_of(Task{}, campaign, one),
                                         device));
    }
    return outcomes;
}

TEST(AcrossScenarios, TheMeanEqualsThatOfSeparateEvaluationsWithTheSameSeeds) {
    const Campaign campaign = over_sites("mean");
    const Case robust = cases(campaign).at(0);
    const std::vector<Outcome> outcomes = separately(robust);
    ASSERT_EQ(outcomes.size(), 2u);
    const Outcome mean = evaluated(campaign);
    EXPECT_DOUBLE_EQ(
        mean.objectives[0].mean,
        (outcomes[0].objectives[0].mean + outcomes[1].objectives[0].mean) / 2);
    ASSERT_EQ(mean.randomisations.size(), outcomes[0].randomisations.size());
    for (std::size_t r = 0; r < mean.randomisations.size(); ++r)
        EXPECT_DOUBLE_EQ(
            mean.randomisations[r],
            (outcomes[0].randomisations[r] + outcomes[1].randomisations[r]) /
                2);
    EXPECT_DOUBLE_EQ(mean.objectives[0].standard_error,
                     estimate(mean.randomisations).standard_error);

    const OutcomeSchema schema =
        outcome_schema(campaign, robust, campaign.sampling);
    ASSERT_TRUE(has_form(schema, mean));
    EXPECT_EQ(find(schema, mean, "absorbed_par")->mean,
              mean.objectives[0].mean);
    const std::size_t by = schema.measured.offset("absorbed_par_by_scenario");
    for (std::size_t s = 0; s < 2; ++s)
        EXPECT_EQ(mean.quantities.at(by + s).mean,
                  outcomes[s].objectives[0].mean);
    EXPECT_EQ(std::get<std::vector<std::string>>(
                  schema.measured.axis("scenario").coordinates),
              (std::vector<std::string>{"ames", "south"}));
}

TEST(AcrossScenarios, TheWorstValueIsTheSmallestOfAMaximisedObjective) {
    const Campaign campaign = over_sites("worst");
    const std::vector<Outcome> outcomes = separately(cases(campaign).at(0));
    const std::size_t smaller =
        outcomes[0].objectives[0].mean < outcomes[1].objectives[0].mean ? 0 : 1;
    const Outcome worst = evaluated(campaign);
    EXPECT_EQ(worst.objectives[0].mean, outcomes[smaller].objectives[0].mean);
    EXPECT_EQ(worst.objectives[0].standard_error,
              outcomes[smaller].objectives[0].standard_error);
    EXPECT_EQ(worst.randomisations, outcomes[smaller].randomisations);
    EXPECT_NE(outcomes[0].objectives[0].mean, outcomes[1].objectives[0].mean);
}

TEST(AcrossScenarios, TheViolationIsThatOfTheWorstScenario) {
    Campaign campaign = changed(narrow, "over = [\"spacing\"]\n");
    const OutcomeSchema schema =
        outcome_schema(campaign, cases(campaign).at(0), campaign.sampling);
    const double mean_lai = find(schema, evaluated(campaign), "lai")->mean;
    // Twice the density doubles the leaf area index.
    const double lai = mean_lai / 1.5;
    campaign.spec.constraints.lai = {0, lai};
    EXPECT_NEAR(evaluated(campaign).violation, 1, 1e-6);
}

//! Constraints are evaluated without within-line variation, so that no plant
//! meets them by chance.
TEST(PlantVariation, DoesNotAffectConstraints) {
    Campaign campaign = changed("", "");
    campaign.spec.constraints.lai = {0, 3};
    const Outcome alike = evaluated(campaign);
    campaign.spec.field.variation = {.length = 0.2, .width = 0.2};
    const Outcome differing = evaluated(campaign);
    EXPECT_GT(alike.violation, 0.1);
    EXPECT_NEAR(differing.violation, alike.violation, 1e-9);
    EXPECT_NE(differing.objectives[0].mean, alike.objectives[0].mean);
}

TEST(AcrossScenarios, ScenarioAxesDoNotMultiplyCases) {
    const Campaign both = changed(std::string(south) + narrow,
                                  "over = [\"site\", \"spacing\"]\n");
    ASSERT_EQ(cases(both).size(), 1u);
    const Case only = cases(both).front();
    EXPECT_EQ(only.name, "all_0807_all_all_r1");
    EXPECT_EQ(cases(both).name(0).name, only.name);
    EXPECT_EQ(only.site_name, "all");
    ASSERT_EQ(only.scenarios.size(), 4u);
    std::vector<std::string> names;
    for (const Case& scenario : only.scenarios) {
        names.push_back(scenario.name);
        EXPECT_EQ(scenario.seed, only.seed);
    }
    EXPECT_EQ(names[1], "ames_0807_762x152_all_r1");
    EXPECT_EQ(names[2], "south_0807_narrow_all_r1");
    EXPECT_EQ(parse_campaign(both.resolved, "again").resolved, both.resolved);
    const Campaign by_site =
        changed(std::string(south) + narrow, "over = [\"spacing\"]\n");
    ASSERT_EQ(cases(by_site).size(), 2u);
    EXPECT_EQ(cases(by_site)[1].name, "south_0807_all_all_r1");
    EXPECT_EQ(cases(by_site)[1].scenarios.at(0).name,
              "south_0807_narrow_all_r1");
    // Resolved texts of earlier campaigns are unchanged.
    EXPECT_EQ(changed("", "").resolved.find("scenarios"), std::string::npos);
    EXPECT_THROW(changed("", "over = [\"climate\"]\n"), InputError);
    EXPECT_THROW(changed("", "over = [\"traits\"]\n"), InputError);
}

TEST(AcrossScenarios, QuantitiesWithDifferentHoursAreNotAveraged) {
    const Campaign campaign = changed(
        "[[day]]\ndate = 2025-06-21\nname = \"june\"\nstart = 05:00:00\n"
        "end = 21:00:00\n",
        "over = [\"day\"]\n");
    const QuantitySet measured =
        outcome_schema(campaign, cases(campaign).at(0), {}).measured;
    EXPECT_FALSE(measured.has("absorbed_by_hour"));
    EXPECT_TRUE(measured.has("absorbed_by_leaf"));
    EXPECT_TRUE(has_form(
        outcome_schema(campaign, cases(campaign).at(0), campaign.sampling),
        evaluated(campaign)));
}

//! Returns a campaign over four sites with different weights.
Campaign over_four_sites(const std::string& how) {
    std::string sites;
    double weight = 1;
    for (const int latitude : {25, 35, 55})
        sites += fmt::format(
            "[[site]]\nname = \"north{}\"\nlatitude = {}\nlongitude = "
            "-100\nutc_offset = -6\nweight = {}\n",
            latitude, latitude, weight += 1);
    return changed(sites, "over = [\"site\"]\n" + how);
}

//! Returns the values by scenario with their weights, the worst first.
std::vector<std::pair<double, double>> ordered(const Campaign& campaign,
                                               const Outcome& outcome) {
    const Case chosen = cases(campaign).at(0);
    const QuantitySet measured =
        outcome_schema(campaign, chosen, campaign.sampling).measured;
    const std::size_t by = measured.offset("absorbed_par_by_scenario");
    const std::size_t weight = measured.offset("scenario_weight");
    std::vector<std::pair<double, double>> values;
    for (std::size_t s = 0; s < 4; ++s)
        values.emplace_back(outcome.quantities.at(by + s).mean,
                            outcome.quantities.at(weight + s).mean);
    std::ranges::sort(values);
    return values;
}

TEST(AcrossScenarios, WeightsCountInMeansQuantilesAndTails) {
    const Campaign over_mean = over_four_sites("");
    const Outcome mean = evaluated(over_mean);
    const auto values = ordered(over_mean, mean);
    double sum = 0, weights = 0;
    for (const auto& [value, weight] : values) {
        sum += weight * value;
        weights += weight;
    }
    EXPECT_NEAR(weights, 1, 1e-12);
    EXPECT_NEAR(mean.objectives[0].mean, sum, 1e-9 * sum);
    EXPECT_DOUBLE_EQ(mean.objectives[0].standard_error,
                     estimate(mean.randomisations).standard_error);

    // A tail that ends in the middle of the second scenario.
    const double tail = values[0].second + values[1].second / 2;
    const auto evaluated_by = [&](const std::string& rule) {
        return evaluated(over_four_sites(fmt::format(
            "scenarios = \"{}\"\nscenario_tail = {}\n", rule, tail)));
    };
    EXPECT_EQ(evaluated_by("quantile").objectives[0].mean, values[1].first);
    const Outcome cvar = evaluated_by("cvar");
    EXPECT_NEAR(cvar.objectives[0].mean,
                (values[0].first * values[0].second +
                 values[1].first * values[1].second / 2) /
                    tail,
                1e-9 * sum);
    EXPECT_NEAR(estimate(cvar.randomisations).mean, cvar.objectives[0].mean,
                1e-9 * sum);
    // The other quantities of a row remain means.
    EXPECT_EQ(cvar.quantities.front().mean, mean.quantities.front().mean);
}

TEST(AcrossScenarios, ProbabilityIsTheWeightOfScenariosAtOrAboveAThreshold) {
    const Campaign over_mean = over_four_sites("");
    // The noise of light must not cross the threshold.
    Task precise;
    precise.tolerance = 0.001;
    const auto values = ordered(over_mean, evaluated(over_mean, precise));
    std::size_t above = 1;
    for (std::size_t s = 2; s < values.size(); ++s)
        if (values[s].first - values[s - 1].first >
            values[above].first - values[above - 1].first)
            above = s;
    const double middle = (values[above - 1].first + values[above].first) / 2;
    double weight = 0;
    for (std::size_t s = above; s < values.size(); ++s)
        weight += values[s].second;
    const Campaign campaign = over_four_sites(fmt::format(
        "scenarios = \"probability\"\nscenario_threshold = {}\n", middle));
    EXPECT_NEAR(evaluated(campaign, precise).objectives[0].mean, weight, 1e-12);
    EXPECT_EQ(outcome_schema(campaign, cases(campaign).at(0), campaign.sampling)
                  .objectives.front()
                  .unit,
              "1");
    EXPECT_THROW(over_four_sites("scenarios = \"probability\"\n"), InputError);
    EXPECT_THROW(over_four_sites("scenario_threshold = 1\n"), InputError);
}

TEST(AcrossScenarios, ScenariosWithoutWeightAreNotEvaluated) {
    const Campaign campaign =
        changed(std::string(south) + "weight = 0\n", "over = [\"site\"]\n");
    const Case only = cases(campaign).front();
    ASSERT_EQ(only.scenarios.size(), 1u);
    EXPECT_EQ(only.scenarios.front().site_name, "ames");
}

}  // namespace
}  // namespace ideotype
