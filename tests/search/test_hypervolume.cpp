// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "ideotype/core/random.hpp"
#include "search/summary.hpp"

namespace ideotype {
namespace {

const std::vector<Sense> both{Sense::maximise, Sense::minimise};

TEST(Hypervolume, VolumeIsTheAreaBetweenFrontAndReference) {
    // The dominated rectangles of 3 x 1 and 1 x 3 overlap in an area of 1.
    const std::vector<std::vector<double>> points{{3, 2}, {1, 0}};
    EXPECT_DOUBLE_EQ(hypervolume(points, {0, 3}, both), 5);
    EXPECT_DOUBLE_EQ(hypervolume({{3, 2}}, {0, 3}, both), 3);
    // One point is dominated, and another equals the reference in one
    // objective.
    EXPECT_DOUBLE_EQ(
        hypervolume({{3, 2}, {1, 0}, {1, 1}, {9, 3}}, {0, 3}, both), 5);
    EXPECT_EQ(hypervolume({{-1, 0}}, {0, 3}, both), 0);
    EXPECT_EQ(hypervolume(std::vector<std::vector<double>>{}, {0, 3}, both), 0);
}

constexpr int randomisations = 8;

//! Makes eleven plants on a Pareto front. Half of their noise is common, as
//! with common random numbers.
Population make_noisy_front(std::uint32_t draw) {
    Population population;
    // The standard deviation of the noise is 1.
    const auto noise = [&](std::uint32_t slot) {
        RandomStream stream(1, Purpose::mutation, draw, slot);
        std::vector<double> values;
        for (int r = 0; r < randomisations; ++r)
            values.push_back(std::sqrt(12) * (stream.uniform() - .5));
        return values;
    };
    const std::vector<double> shared = noise(99);
    for (std::uint32_t i = 0; i <= 10; ++i) {
        const double x = i / 10.;
        Individual one;
        one.status = Status::done;
        one.objectives = {{std::sqrt(x), 0}, {x, 0}};
        const std::vector<double> unshared = noise(i);
        double sum = 0;
        for (std::size_t r = 0; r < randomisations; ++r) {
            const double error = .02 * (unshared[r] + shared[r]);
            one.randomisations.push_back(std::sqrt(x) + error);
            sum += error;
        }
        one.objectives[0].mean += sum / randomisations;
        one.randomisations.insert(one.randomisations.end(), randomisations, x);
        population.push_back(std::move(one));
    }
    return population;
}

TEST(Hypervolume, StandardErrorIsTheSpreadOfRepeatedEvaluations) {
    constexpr std::uint32_t repeats = 400;
    std::vector<double> volumes;
    double variance = 0;
    for (std::uint32_t draw = 0; draw < repeats; ++draw) {
        const Estimate volume =
            hypervolume(make_noisy_front(draw), {0, 1.1}, both);
        volumes.push_back(volume.mean);
        variance += volume.standard_error * volume.standard_error / repeats;
    }
    const double spread =
        estimate(volumes).standard_error * std::sqrt(double{repeats});
    EXPECT_NEAR(std::sqrt(variance) / spread, 1, .1);
    EXPECT_GT(spread, .005);
}

TEST(Hypervolume, InfeasiblePlantsDoNotContribute) {
    Population population = make_noisy_front(0);
    const double volume = hypervolume(population, {0, 1.1}, both).mean;
    population[10].violation = .1;
    population[9].status = Status::failed;
    EXPECT_LT(hypervolume(population, {0, 1.1}, both).mean, volume);
    for (Individual& individual : population) individual.violation = 1;
    EXPECT_EQ(hypervolume(population, {0, 1.1}, both).mean, 0);
}

TEST(Hypervolume, DefaultReferenceIsTheWorstOfTheFirstGeneration) {
    const Population first = make_noisy_front(0), second = make_noisy_front(1);
    const std::vector<double> worst = find_worst(first, both);
    EXPECT_EQ(worst[0], first[0].objectives[0].mean);
    EXPECT_EQ(worst[1], 1);
    Summarizer summarized({}, both, {});
    EXPECT_EQ(summarized(first).hypervolume,
              hypervolume(first, worst, both).mean);
    const GenerationSummary summary = summarized(second);
    // The summary contains the hypervolume of all rows so far.
    Population combined = first;
    combined.insert(combined.end(), second.begin(), second.end());
    EXPECT_DOUBLE_EQ(summary.hypervolume,
                     hypervolume(combined, worst, both).mean);
    EXPECT_GT(summary.hypervolume_standard_error, 0);
    EXPECT_EQ(Summarizer({}, both, {0, 2})(second).hypervolume,
              hypervolume(second, {0, 2}, both).mean);
    EXPECT_TRUE(
        std::isnan(Summarizer({}, {Sense::maximise}, {})(first).hypervolume));
}

}  // namespace
}  // namespace ideotype
