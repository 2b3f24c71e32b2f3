// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "ideotype/core/random.hpp"
#include "search/optimizer.hpp"

namespace ideotype {
namespace {

constexpr std::uint32_t population = 20;
constexpr std::uint32_t window = 33;

std::unique_ptr<Optimizer> search() {
    SearchSettings settings;
    settings.population = population;
    settings.window = window;
    const GeneSpace genes(6, {"x", "1", -5, 5, false, true});
    return make_steady_state(settings, {genes, Genome(6, 3), {Sense::minimise}},
                             7);
}

Individual evaluated(const Candidate& candidate) {
    double sum = 0;
    for (const double x : candidate.genome) sum += x * x;
    return {candidate, Status::done, {{sum, 0.01}}, 0};
}

Candidate propose(Optimizer& optimizer, std::uint32_t row) {
    return optimizer.propose(row / population, row % population);
}

//! Rows of a search that learns each as soon as it is proposed.
Population searched(std::uint32_t rows) {
    const auto optimizer = search();
    Population all;
    for (std::uint32_t row = 0; row < rows; ++row) {
        all.push_back(evaluated(propose(*optimizer, row)));
        optimizer->learn(all.back());
    }
    return all;
}

TEST(SteadyState, NeedsAllRowsButThoseInTheWindow) {
    const auto optimizer = search();
    for (std::uint32_t row = 0; row < 200; ++row)
        EXPECT_EQ(optimizer->needs(row / population, row % population),
                  row < window ? 0 : row - window + 1);
}

// Contract C3: whatever else is known when a row is proposed.
TEST(SteadyState, CandidatesFollowFromTheRowsTheyNeedAlone) {
    constexpr std::uint32_t rows = 400;
    const Population all = searched(rows);
    const auto late = search();
    std::uint32_t known = 0;
    RandomStream stream(5, Purpose::jitter);
    for (std::uint32_t row = 0; row < rows; ++row) {
        const auto least = static_cast<std::uint32_t>(
            late->needs(row / population, row % population));
        const std::uint32_t most = row;
        const std::uint32_t wanted = least + stream.below(most - least + 1);
        while (known < wanted) late->learn(all[known++]);
        EXPECT_EQ(propose(*late, row), all[row].candidate) << row;
    }
}

TEST(SteadyState, ParentsAreTheGenerationBeforeTheWindow) {
    const Population all = searched(400);
    for (std::int64_t row = 0; row < 400; ++row) {
        const Candidate& each = all[static_cast<std::size_t>(row)].candidate;
        const std::int64_t end = row - window + 1;
        if (end < population) {
            EXPECT_EQ(each.origin,
                      row == 0 ? Origin::baseline : Origin::random);
            EXPECT_EQ(each.parents[0], no_parent);
            continue;
        }
        const bool is_elite = row % population < 2;
        EXPECT_EQ(each.origin, is_elite ? Origin::elite : Origin::child);
        EXPECT_GE(each.parents[0], end - population);
        EXPECT_LT(each.parents[0], end);
    }
}

TEST(SteadyState, Converges) {
    const Population all = searched(6000);
    EXPECT_LT(all[5980].objectives[0].mean, 0.01);
}

TEST(SteadyState, OffersTheBestOfTheLastGeneration) {
    const auto optimizer = search();
    Population all;
    for (std::uint32_t row = 0; row < 10 * population; ++row) {
        all.push_back(evaluated(propose(*optimizer, row)));
        optimizer->learn(all.back());
    }
    const auto best = optimizer->best(3);
    ASSERT_EQ(best.size(), 3U);
    EXPECT_GE(best[0].parents[0], 9 * population);
    for (std::uint32_t row = 9 * population; row < 10 * population; ++row)
        EXPECT_GE(all[row].objectives[0].mean,
                  evaluated(best[0]).objectives[0].mean);
}

}  // namespace
}  // namespace ideotype
