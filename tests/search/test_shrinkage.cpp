// SPDX-License-Identifier: Apache-2.0
// Tests the expected value of the best of many noisy values against known true
// values.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "individual.hpp"
#include "search/order.hpp"
#include "search/shrinkage.hpp"
#include "search/summary.hpp"

namespace ideotype {
namespace {

constexpr std::size_t draws = 8;

//! A generation with known true values and noise that is partly common.
struct Made {
    Population population;
    std::vector<double> values;
};

Made make_generation(std::mt19937_64& random, std::size_t count, double spread,
                     double noise, double shared) {
    std::normal_distribution<double> normal;
    Made made;
    std::vector<double> common(draws);
    const double per_draw = std::sqrt(static_cast<double>(draws));
    for (double& x : common) x = shared * per_draw * normal(random);
    for (std::size_t i = 0; i < count; ++i) {
        const double value = 10 + spread * normal(random);
        Individual row = make_individual({static_cast<double>(i)}, 0);
        for (const double x : common)
            row.randomisations.push_back(value + x +
                                         noise * per_draw * normal(random));
        row.objectives = {estimate(row.randomisations)};
        made.population.push_back(row);
        made.values.push_back(value);
    }
    return made;
}

struct Bias {
    Estimate raw, expected;
    double covered = 0;  //!< share of values within two standard errors
};

Bias estimate_bias(double spread, double noise, double shared) {
    constexpr int trials = 2000;
    std::mt19937_64 random(7);
    std::vector<double> raw, expected;
    double covered = 0;
    for (int i = 0; i < trials; ++i) {
        const Made made = make_generation(random, 24, spread, noise, shared);
        const std::size_t best =
            best_distinct(made.population, 1, {Sense::maximise}).front();
        const Estimate estimate_of_best = shrink(made.population, best);
        raw.push_back(made.population[best].objectives.front().mean -
                      made.values[best]);
        expected.push_back(estimate_of_best.mean - made.values[best]);
        covered +=
            std::abs(expected.back()) < 2 * estimate_of_best.standard_error
                ? 1.
                : 0.;
    }
    return {estimate(raw), estimate(expected), covered / trials};
}

TEST(Shrinkage, SelectionBiasOfTheBestIsRemoved) {
    for (const double noise : {.3, 1., 3.})
        for (const double shared : {0., .5}) {
            const auto [raw, expected, covered] =
                estimate_bias(1, noise, shared);
            EXPECT_GT(raw.mean, .15 * noise) << noise;
            EXPECT_LT(std::abs(expected.mean), .2 * raw.mean) << noise;
            EXPECT_NEAR(covered, .96, .035) << noise;
        }
}

TEST(Shrinkage, ExactValuesAreNotShrunk) {
    std::mt19937_64 random(1);
    Population exact = make_generation(random, 12, 1, 0, 0).population;
    const Estimate estimated = shrink(exact, 3);
    EXPECT_NEAR(estimated.mean, exact[3].objectives.front().mean, 1e-12);
    EXPECT_NEAR(estimated.standard_error, 0, 1e-12);
}

TEST(Shrinkage, InfeasiblePlantsHaveNoEffect) {
    std::mt19937_64 random(2);
    Population some = make_generation(random, 12, 1, 1, 0).population;
    const Estimate before = shrink(some, 0);
    Individual far = make_individual({99}, 1000, 3);
    far.randomisations.assign(draws, 1000);
    some.push_back(far);
    some.push_back(make_failed_individual({98}, 1000));
    const Estimate after = shrink(some, 0);
    EXPECT_DOUBLE_EQ(after.mean, before.mean);
    EXPECT_DOUBLE_EQ(after.standard_error, before.standard_error);
}

TEST(Shrinkage, FewRowsAreShrunkToTheirMean) {
    std::mt19937_64 random(3);
    const Population three = make_generation(random, 3, 1, 1, 0).population;
    double mean = 0;
    for (const Individual& row : three) mean += row.objectives.front().mean / 3;
    EXPECT_NEAR(shrink(three, 1).mean, mean, 1e-12);
}

TEST(Shrinkage, ExpectedBestIsInTheSummary) {
    std::mt19937_64 random(4);
    const Population some = make_generation(random, 24, 1, 1, 0).population;
    const GenerationSummary summary = summarize(some, {}, Sense::minimise);
    EXPECT_GT(summary.expected_best.mean, summary.best);
    EXPECT_DOUBLE_EQ(summary.expected_best.mean,
                     shrink(some, summary.best_slot).mean);
}

}  // namespace
}  // namespace ideotype
