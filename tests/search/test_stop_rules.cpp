// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "search/stop_rules.hpp"

namespace ideotype {
namespace {

constexpr Sense maximise = Sense::maximise, minimise = Sense::minimise;

//! Makes the progress of generations with the given means; best values equal
//! the means.
Progress make_progress(const std::vector<double>& means) {
    Progress progress;
    for (const double mean : means)
        progress.generations.push_back({.best = mean, .mean = mean});
    return progress;
}

//! Makes the progress after generations of infeasible plants.
Progress make_infeasible(const std::vector<double>& violations) {
    Progress progress;
    for (const double violation : violations)
        progress.generations.push_back(
            {.best = 20, .mean = 20, .violation = violation});
    return progress;
}

StopRules only_generations(int count = 5) {
    StopRules rules;
    rules.generations = count;
    return rules;
}

TEST(StopRules, GenerationsEndTheEvolution) {
    const StopRules rules = only_generations();
    EXPECT_EQ(finished(rules, make_progress({1, 1, 1, 1}), maximise),
              std::nullopt);
    EXPECT_EQ(finished(rules, make_progress({1, 1, 1, 1, 1}), maximise),
              "generations");
}

//! Makes values around a straight line, with alternating scatter.
std::vector<double> make_line(double slope, int count) {
    std::vector<double> means;
    for (int i = 0; i < count; ++i)
        means.push_back(10 + slope * i + (i % 3 == 0 ? 1 : -0.5));
    return means;
}

TEST(StopRules, NoGainIsASlopeBelowTwiceItsError) {
    StopRules rules = only_generations(1000);
    rules.no_gain = 9;
    EXPECT_EQ(finished(rules, make_progress(make_line(0, 8)), maximise),
              std::nullopt);
    EXPECT_EQ(finished(rules, make_progress(make_line(0, 9)), maximise),
              "no_gain");
    EXPECT_EQ(finished(rules, make_progress(make_line(-1, 9)), maximise),
              "no_gain");
    EXPECT_EQ(finished(rules, make_progress(make_line(-1, 9)), minimise),
              std::nullopt);
    // The regression slope of the scatter alone is -0.075 with a standard error
    // of 0.0996.
    EXPECT_EQ(finished(rules, make_progress(make_line(0.2, 9)), maximise),
              "no_gain");
    EXPECT_EQ(finished(rules, make_progress(make_line(0.4, 9)), maximise),
              std::nullopt);
    EXPECT_EQ(
        finished(rules, make_progress(std::vector<double>(9, 3)), maximise),
        "no_gain");
    EXPECT_EQ(
        finished(rules, make_infeasible({1, 1, 1, 1, 1, 1, 1, 1, 1}), maximise),
        std::nullopt);
}

//! Makes generations of 20 evaluations.
std::vector<GenerationSummary> make_generations(
    const std::vector<double>& means) {
    std::vector<GenerationSummary> generations;
    for (const double mean : means)
        generations.push_back({.best = mean, .mean = mean, .evaluations = 20});
    return generations;
}

TEST(GainLeft, IsTheRiseSinceHalfOfTheEvaluations) {
    std::vector<double> means(20, 10);
    for (int i = 10; i < 20; ++i) means[static_cast<std::size_t>(i)] = 11;
    const auto up = gain_left(make_generations(means), 8, maximise);
    ASSERT_TRUE(up);
    EXPECT_DOUBLE_EQ(up->so_far, 3);
    EXPECT_DOUBLE_EQ(up->most, 1.02);
    const auto down = gain_left(make_generations(means), 12, minimise);
    ASSERT_TRUE(down);
    EXPECT_DOUBLE_EQ(down->so_far, 1);
    // A fall leaves a bound by the error, which is 0 here.
    EXPECT_DOUBLE_EQ(down->most, 0);
}

TEST(GainLeft, IsAtLeastATenthOfTheErrorOfTheRise) {
    // Both levels are means of the last generations: four of 20, and three of
    // 10, since a fifth of 10 are fewer.
    std::vector<double> means(20, 10);
    means[19] = 14;
    means[9] = 14;
    const auto found = gain_left(make_generations(means), 8, maximise);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->most, 0.102 * std::hypot(1., 4 / 3.), 1e-12);
}

TEST(GainLeft, IsUnknownBeforeItsTest) {
    const std::vector<double> few(12, 10);
    EXPECT_FALSE(gain_left(make_generations(few), 8, maximise));
    const std::vector<double> enough(13, 10);
    EXPECT_TRUE(gain_left(make_generations(enough), 8, maximise));
    EXPECT_FALSE(
        gain_left(make_generations(enough), Progress{}.baseline, maximise));
    auto infeasible = make_generations(enough);
    infeasible[5].violation = 1;
    EXPECT_FALSE(gain_left(infeasible, 8, maximise));
}

TEST(StopRules, GainLeftIsAShareOfTheGainSoFar) {
    StopRules rules = only_generations(1000);
    rules.gain_left = 0.1;
    std::vector<double> means(20, 10);
    for (std::size_t i = 10; i < 20; ++i) means[i] = 11;
    Progress progress{make_generations(means)};
    EXPECT_EQ(finished(rules, progress, maximise), std::nullopt);
    progress.baseline = 8;
    EXPECT_EQ(finished(rules, progress, maximise), std::nullopt);
    progress.baseline = 0;
    EXPECT_EQ(finished(rules, progress, maximise), "gain_left");
    // Without a gain no share is small.
    progress.baseline = 12;
    EXPECT_EQ(finished(rules, progress, maximise), std::nullopt);
}

TEST(StopRules, SeveralObjectivesAreJudgedByTheirHypervolume) {
    Progress progress = make_progress({5, 4, 3, 2, 1, 0});
    const std::vector<double> volumes{1, 2, 2.5, 2.9, 3, 3.1};
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        progress.generations[i].hypervolume = volumes[i];
        progress.generations[i].hypervolume_standard_error = 0.3;
    }
    StopRules rules = only_generations(1000);
    rules.no_gain = 5;
    EXPECT_EQ(finished(rules, progress, maximise), std::nullopt);
    progress.generations[1].hypervolume = 2.6;
    EXPECT_EQ(finished(rules, progress, maximise), "no_gain");
}

TEST(StopRules, EvaluationsAndWallTimeAreTotals) {
    StopRules rules = only_generations();
    rules.evaluations = 100;
    rules.wall_time = 60;
    Progress progress = make_progress({1, 1});
    progress.generations[0].evaluations = 60;
    progress.generations[1].evaluations = 39;
    progress.wall_time = 59;
    EXPECT_EQ(finished(rules, progress, maximise), std::nullopt);
    progress.wall_time = 60;
    EXPECT_EQ(finished(rules, progress, maximise), "wall_time");
    progress.generations[1].evaluations = 40;
    EXPECT_EQ(finished(rules, progress, maximise), "evaluations");
}

}  // namespace
}  // namespace ideotype
