// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "ideotype/core/random.hpp"

namespace ideotype {

namespace {

using Words = std::array<std::uint32_t, 4>;

constexpr std::uint64_t seed = 0x0123456789abcdef;

std::vector<std::uint64_t> draw_numbers(RandomStream stream) {
    std::vector<std::uint64_t> draws(100);
    for (std::uint64_t& draw : draws) draw = stream.bits64();
    return draws;
}

}  // namespace

// Expected values: the known answers published with Random123 (kat_vectors,
// philox4x32 10).
TEST(Philox, WordsAgreeWithPublishedAnswers) {
    constexpr std::uint32_t ones = 0xffffffff;
    EXPECT_EQ(philox4x32({0, 0, 0, 0}, {0, 0}),
              (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
    EXPECT_EQ(philox4x32({ones, ones, ones, ones}, {ones, ones}),
              (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
    EXPECT_EQ(philox4x32({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344},
                         {0xa4093822, 0x299f31d0}),
              (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(RandomStream, BitsAreBlocksOfPhiloxInOrder) {
    RandomStream stream(seed, Purpose::mutation, 7, 9);
    for (std::uint32_t block = 0; block < 3; ++block)
        for (const std::uint32_t word :
             philox4x32({block, 9, 7, 4}, {0x89abcdef, 0x01234567}))
            EXPECT_EQ(stream.bits(), word);
}

TEST(RandomStream, StreamIsAPureFunctionOfItsKey) {
    EXPECT_EQ(draw_numbers(RandomStream(seed, Purpose::jitter, 3, 4)),
              draw_numbers(RandomStream(seed, Purpose::jitter, 3, 4)));
}

TEST(RandomStream, StreamsOfDifferentKeysShareNoDraw) {
    std::set<std::uint64_t> draws;
    std::size_t drawn = 0;
    const auto add = [&](const RandomStream& stream) {
        for (const std::uint64_t draw : draw_numbers(stream)) {
            draws.insert(draw);
            ++drawn;
        }
    };
    for (const std::uint64_t key : {seed, seed + 1, seed + 0x100000000})
        for (const Purpose purpose : {Purpose::selection, Purpose::crossover})
            for (const std::uint32_t generation : {0u, 1u, 2u})
                for (const std::uint32_t slot : {0u, 1u, 2u})
                    add(RandomStream(key, purpose, generation, slot));
    EXPECT_EQ(draws.size(), drawn);
}

TEST(RandomStream, UniformNumbersHaveTheRightMomentsAndRange) {
    RandomStream stream(seed, Purpose::jitter);
    constexpr int n = 100'000;
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < n; ++i) {
        const double x = stream.uniform();
        ASSERT_GE(x, 0);
        ASSERT_LT(x, 1);
        sum += x;
        squares += x * x;
    }
    // Tolerances are four standard errors.
    EXPECT_NEAR(sum / n, 1.0 / 2, 4 * std::sqrt(1.0 / 12 / n));
    EXPECT_NEAR(squares / n, 1.0 / 3, 4 * std::sqrt(4.0 / 45 / n));
}

TEST(RandomStream, UniformNumbersStayInsideBounds) {
    RandomStream stream(seed, Purpose::jitter);
    double smallest = 1e9;
    double largest = -1e9;
    for (int i = 0; i < 10'000; ++i) {
        const double x = stream.uniform(-10, 30);
        smallest = std::min(smallest, x);
        largest = std::max(largest, x);
    }
    EXPECT_GE(smallest, -10);
    EXPECT_LT(smallest, -9.9);
    EXPECT_LT(largest, 30);
    EXPECT_GT(largest, 29.9);
}

TEST(RandomStream, WholeNumbersAreEquallyLikely) {
    for (const std::uint32_t n : {1u, 2u, 7u, 100u}) {
        RandomStream stream(seed, Purpose::selection, n);
        constexpr int draws = 100'000;
        std::vector<double> counts(n);
        for (int i = 0; i < draws; ++i) {
            const std::uint32_t x = stream.below(n);
            ASSERT_LT(x, n);
            ++counts[x];
        }
        const double expected = draws / static_cast<double>(n);
        double chi_squared = 0;
        for (const double count : counts)
            chi_squared += (count - expected) * (count - expected) / expected;
        // The mean is n - 1 and the variance 2 (n - 1); the tolerance is four
        // standard deviations.
        EXPECT_LE(chi_squared, n - 1 + 4 * std::sqrt(2.0 * (n - 1))) << n;
    }
}

TEST(RandomStream, WholeNumbersHaveNoBiasForLargeRanges) {
    // With this n, the remainder of a division would be in the lower half twice
    // as often as in the upper half.
    constexpr std::uint32_t n = 0xaaaaaaab;
    RandomStream stream(seed, Purpose::selection);
    int lower = 0;
    for (int i = 0; i < 30'000; ++i)
        if (stream.below(n) < n / 2) ++lower;
    EXPECT_NEAR(lower, 15'000, 4 * std::sqrt(30'000 / 4.0));
}

}  // namespace ideotype
