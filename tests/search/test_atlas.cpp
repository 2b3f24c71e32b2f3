// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "ideotype/core/random.hpp"
#include "search/optimizer.hpp"

namespace ideotype {
namespace {

constexpr int cells = 5;

SearchSettings settings() {
    SearchSettings settings;
    settings.optimizer = OptimizerKind::atlas;
    settings.population = 40;
    settings.axes = {{"a", {0, 1}, cells}, {"b", {0, 1}, cells}};
    return settings;
}

SearchSpace space() {
    return {{{"a", "m", 0, 1.2}, {"b", "m", 0, 1}, {"c", "m", 0, 1}},
            {0.1, 0.1, 0.1}};
}

//! Returns the noise-free value of a plant; the optimum of the gene c is 0.7.
double value(const Genome& genome) {
    return 1 - std::pow(genome[2] - 0.7, 2);
}

//! Evaluates plants; the first two genes are their features.
Population evaluate(const std::vector<Candidate>& candidates,
                    std::uint32_t generation, double noise) {
    Population population;
    for (const Candidate& candidate : candidates) {
        const auto slot = static_cast<std::uint32_t>(population.size());
        RandomStream stream(3, Purpose::sample, generation, slot);
        const double error = noise * (stream.uniform() - 0.5);
        const Genome& genome = candidate.genome;
        population.push_back({candidate,
                              Status::done,
                              {{value(genome) + error, noise}},
                              0,
                              {},
                              {genome[0], genome[1]}});
    }
    return population;
}

int find_cell(const Genome& genome) {
    return static_cast<int>(genome[0] * cells) * cells +
           static_cast<int>(genome[1] * cells);
}

std::vector<Candidate> find_leaders(std::uint32_t generations, double noise) {
    const auto optimizer = make_atlas(settings(), space(), 7);
    for (std::uint32_t g = 0; g < generations; ++g)
        optimizer->tell(evaluate(optimizer->ask(), g, noise));
    return optimizer->best(1000);
}

TEST(Atlas, BestPlantOfEachCellIsFound) {
    const std::vector<Candidate> leaders = find_leaders(100, 0);
    ASSERT_EQ(leaders.size(), std::size_t{cells * cells});
    std::map<int, Genome> by_cell;
    for (const Candidate& leader : leaders) {
        by_cell[find_cell(leader.genome)] = leader.genome;
        EXPECT_NEAR(leader.genome[2], 0.7, 0.05);
        EXPECT_LT(leader.genome[0], 1) << "beyond the grid";
    }
    EXPECT_EQ(by_cell.size(), leaders.size());
    EXPECT_GE(value(leaders.front().genome), value(leaders.back().genome));
}

TEST(Atlas, LuckyEvaluationsDoNotLead) {
    // By chance a noisy evaluation may exceed the best possible value by up to
    // 0.5.
    double loss = 0;
    const std::vector<Candidate> leaders = find_leaders(200, 1);
    for (const Candidate& leader : leaders) loss += 1 - value(leader.genome);
    EXPECT_EQ(leaders.size(), std::size_t{cells * cells});
    EXPECT_LT(loss / static_cast<double>(leaders.size()), 0.05);
}

TEST(Atlas, ChallengersAndLeadersAreEvaluatedTogether) {
    const auto optimizer = make_atlas(settings(), space(), 7);
    optimizer->tell(evaluate(optimizer->ask(), 0, 0));
    // The second generation fills the same cells as the first, with better
    // plants.
    Population better = evaluate(optimizer->ask(), 1, 0);
    for (Individual& individual : better)
        individual.objectives.front().mean += 1;
    optimizer->tell(better);
    const std::vector<Candidate> next = optimizer->ask();
    ASSERT_EQ(next[0].origin, Origin::elite);
    ASSERT_EQ(next[1].origin, Origin::elite);
    EXPECT_EQ(find_cell(next[0].genome), find_cell(next[1].genome));
    EXPECT_NE(next[0].genome, next[1].genome);
    EXPECT_GE(next[1].parents[0], 40) << "a row of the second generation";
}

TEST(Atlas, ResumedSearchHasTheSameBits) {
    const auto whole = make_optimizer(settings(), space(), 7);
    std::vector<Individual> rows;
    for (std::uint32_t g = 0; g < 20; ++g) {
        std::vector<Candidate> candidates;
        for (std::uint32_t slot = 0; slot < whole->size(g); ++slot)
            candidates.push_back(whole->propose(g, slot));
        for (Individual& row : evaluate(candidates, g, 0.5)) {
            rows.push_back(row);
            whole->learn(std::move(row));
        }
    }
    const auto resumed = make_optimizer(settings(), space(), 7);
    for (const Individual& row : rows) resumed->learn(row);
    ASSERT_EQ(whole->needs(20), resumed->needs(20));
    for (std::uint32_t slot = 40; slot-- > 0;)
        EXPECT_EQ(whole->propose(20, slot), resumed->propose(20, slot));
    EXPECT_EQ(whole->best(100), resumed->best(100));
}

TEST(Atlas, FailedAndInfeasiblePlantsAreExcluded) {
    const auto optimizer = make_atlas(settings(), space(), 7);
    Population rows = evaluate(optimizer->ask(), 0, 0);
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (i % 2 == 0)
            rows[i].violation = 1;
        else
            rows[i] = {rows[i].candidate, Status::failed, {}};
    optimizer->tell(rows);
    EXPECT_TRUE(optimizer->best(10).empty());
    for (const Candidate& candidate : optimizer->ask())
        EXPECT_EQ(candidate.origin, Origin::random);
}

}  // namespace
}  // namespace ideotype
