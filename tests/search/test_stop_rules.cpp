// SPDX-License-Identifier: Apache-2.0
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
