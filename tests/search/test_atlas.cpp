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

//! Returns the value of a plant without noise: c is best at 0.7.
double value(const Genome& genome) {
    return 1 - std::pow(genome[2] - 0.7, 2);
}

//! Evaluates plants whose features are their first two genes.
Population evaluated(const std::vector<Candidate>& candidates,
                     std::uint32_t generation, double noise) {
    Population population;
    for (const Candidate& each : candidates) {
        const auto slot = static_cast<std::uint32_t>(population.size());
        RandomStream stream(3, Purpose::sample, generation, slot);
        const double error = noise * (stream.uniform() - 0.5);
        const Genome& genome = each.genome;
        population.push_back({each,
                              Status::done,
                              {{value(genome) + error, noise}},
                              0,
                              {},
                              {genome[0], genome[1]}});
    }
    return population;
}

int cell_of(const Genome& genome) {
    return static_cast<int>(genome[0] * cells) * cells +
           static_cast<int>(genome[1] * cells);
}

std::vector<Candidate> leaders(std::uint32_t generations, double noise) {
    const auto optimizer = make_atlas(settings(), space(), 7);
    for (std::uint32_t g = 0; g < generations; ++g)
        optimizer->tell(evaluated(optimizer->ask(), g, noise));
    return optimizer->best(1000);
}

TEST(Atlas, FindsTheBestPlantOfEachCell) {
    const std::vector<Candidate> found = leaders(100, 0);
    ASSERT_EQ(found.size(), std::size_t{cells * cells});
    std::map<int, Genome> by_cell;
    for (const Candidate& each : found) {
        by_cell[cell_of(each.genome)] = each.genome;
        EXPECT_NEAR(each.genome[2], 0.7, 0.05);
        EXPECT_LT(each.genome[0], 1) << "beyond the grid";
    }
    EXPECT_EQ(by_cell.size(), found.size());
    EXPECT_GE(value(found.front().genome), value(found.back().genome));
}

TEST(Atlas, LuckDoesNotLead) {
    // A lucky evaluation exceeds the best plant by up to 0.5.
    double loss = 0;
    const std::vector<Candidate> found = leaders(200, 1);
    for (const Candidate& each : found) loss += 1 - value(each.genome);
    EXPECT_EQ(found.size(), std::size_t{cells * cells});
    EXPECT_LT(loss / static_cast<double>(found.size()), 0.05);
}

TEST(Atlas, ChallengersAndLeadersAreEvaluatedTogether) {
    const auto optimizer = make_atlas(settings(), space(), 7);
    optimizer->tell(evaluated(optimizer->ask(), 0, 0));
    // The second generation repeats the cells of the first with better plants.
    Population better = evaluated(optimizer->ask(), 1, 0);
    for (Individual& each : better) each.objectives.front().mean += 1;
    optimizer->tell(better);
    const std::vector<Candidate> next = optimizer->ask();
    ASSERT_EQ(next[0].origin, Origin::elite);
    ASSERT_EQ(next[1].origin, Origin::elite);
    EXPECT_EQ(cell_of(next[0].genome), cell_of(next[1].genome));
    EXPECT_NE(next[0].genome, next[1].genome);
    EXPECT_GE(next[1].parents[0], 40) << "a row of the second generation";
}

TEST(Atlas, ResumesWithTheSameBits) {
    const auto whole = make_optimizer(settings(), space(), 7);
    std::vector<Individual> rows;
    for (std::uint32_t g = 0; g < 20; ++g) {
        std::vector<Candidate> candidates;
        for (std::uint32_t slot = 0; slot < whole->size(g); ++slot)
            candidates.push_back(whole->propose(g, slot));
        for (Individual& row : evaluated(candidates, g, 0.5)) {
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

TEST(Atlas, LeavesOutPlantsThatFailOrBreakConstraints) {
    const auto optimizer = make_atlas(settings(), space(), 7);
    Population rows = evaluated(optimizer->ask(), 0, 0);
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (i % 2 == 0)
            rows[i].violation = 1;
        else
            rows[i] = {rows[i].candidate, Status::failed, {}};
    optimizer->tell(rows);
    EXPECT_TRUE(optimizer->best(10).empty());
    for (const Candidate& each : optimizer->ask())
        EXPECT_EQ(each.origin, Origin::random);
}

}  // namespace
}  // namespace ideotype
