// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "search/cma_es/choice_distribution.hpp"
#include "search/cma_es/integer_margin.hpp"

namespace ideotype {
namespace {

//! Updates of the package cmaes, which tests/search/published_catcmawm.py
//! writes.
std::ifstream published() {
    return std::ifstream(IDEOTYPE_TEST_DATA "/catcmawm.txt");
}

template <class T>
std::vector<T> read(std::istream& file, std::size_t count) {
    std::vector<T> numbers(count);
    for (T& number : numbers) file >> number;
    return numbers;
}

void skip_lines(std::istream& file, int count) {
    std::string line;
    for (int i = 0; i < count; ++i) std::getline(file, line);
}

TEST(IntegerMargin, CorrectionsAgreeWithThePackageCmaes) {
    constexpr std::size_t better_half = 4;
    constexpr double tolerance = 1e-6;
    std::ifstream file = published();
    std::string kind;
    int searches = 0, corrected = 0, centred = 0;
    for (; file >> kind && kind == "integer"; ++searches) {
        std::size_t count = 0;
        double margin = 0;
        int generations = 0;
        file >> count >> margin >> generations;
        IntegerMargin integer(count, margin);
        for (int g = 0; g < generations; ++g) {
            const double mean = read<double>(file, 1)[0];
            const auto drawn = read<double>(file, better_half);
            const auto expected = read<double>(file, better_half);
            std::vector<double> positions = drawn;
            integer.centre(positions, mean);
            for (std::size_t i = 0; i < better_half; ++i)
                EXPECT_NEAR(positions[i], expected[i], tolerance);
            centred += positions == drawn ? 0 : 1;
            const auto updated = read<double>(file, 2);
            const auto after = read<double>(file, 2);
            const auto [new_mean, deviation] =
                integer.correct({updated[0], updated[1]});
            EXPECT_NEAR(new_mean, after[0], tolerance) << count << ' ' << g;
            EXPECT_NEAR(deviation, after[1], tolerance) << count << ' ' << g;
            corrected += std::abs(new_mean - updated[0]) > tolerance ? 1 : 0;
        }
    }
    EXPECT_EQ(searches, 4);
    EXPECT_GT(centred, 50);
    EXPECT_GT(corrected, 100);
}

TEST(IntegerMargin, NarrowDistributionStillReachesOtherValues) {
    IntegerMargin integer(6, 0.1);
    const auto leaves = [](const IntegerMargin::Marginal& x, double lower,
                           double upper) {
        const auto below = [&](double position) {
            return std::erfc((x.mean - position) / x.deviation / std::sqrt(2)) /
                   2;
        };
        return below(lower) + 1 - below(upper);
    };
    EXPECT_NEAR(leaves(integer.correct({2.1, 1e-6}), 1.5, 2.5), 0.1, 1e-9);
    EXPECT_NEAR(leaves(integer.correct({-3, 1e-6}), -1e9, 0.5), 0.1, 1e-9);
    EXPECT_NEAR(leaves(integer.correct({7, 1e-6}), 4.5, 1e9), 0.1, 1e-9);
}

TEST(ChoiceDistribution, UpdatesAgreeWithThePackageCmaes) {
    std::ifstream file = published();
    std::string kind;
    int searches = 0;
    while (file >> kind) {
        std::size_t choices = 0, population = 0;
        double margin = 0;
        int generations = 0;
        if (kind == "integer") {
            file >> choices >> margin >> generations;
            skip_lines(file, 1 + 5 * generations);
            continue;
        }
        ++searches;
        file >> choices >> population >> margin >> generations;
        std::vector<std::vector<double>> first;
        for (const std::size_t count : read<std::size_t>(file, choices))
            first.emplace_back(count, 1 / static_cast<double>(count));
        ChoiceDistribution distribution(first, margin);
        for (int g = 0; g < generations; ++g) {
            std::vector<ChoiceDistribution::Entries> ranked;
            for (std::size_t i = 0; i < population; ++i)
                ranked.push_back(read<std::size_t>(file, choices));
            distribution.update(ranked);
            for (const std::vector<double>& ours : distribution.probabilities())
                for (std::size_t k = 0; k < ours.size(); ++k)
                    EXPECT_NEAR(ours[k], read<double>(file, 1)[0], 1e-6)
                        << choices << ' ' << g;
        }
    }
    EXPECT_EQ(searches, 3);
}

TEST(ChoiceDistribution, EntriesAreDrawnWithTheirProbabilities) {
    const std::vector<double> probabilities{0.5, 0.2, 0.3};
    const ChoiceDistribution distribution({probabilities}, 0.1);
    constexpr int draws = 20000;
    std::vector<double> counts(3);
    RandomStream stream(1, Purpose::sample, 0, 0);
    for (int i = 0; i < draws; ++i) ++counts[distribution.draw(stream)[0]];
    for (std::size_t k = 0; k < 3; ++k) {
        const double p = probabilities[k];
        EXPECT_NEAR(counts[k] / draws, p, 4 * std::sqrt(p * (1 - p) / draws));
    }
    EXPECT_EQ(distribution.mode(), ChoiceDistribution::Entries{0});
}

}  // namespace
}  // namespace ideotype
