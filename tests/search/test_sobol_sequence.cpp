// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "ideotype/core/estimate.hpp"
#include "ideotype/core/sobol.hpp"
#include "search/sobol_sequence.hpp"

namespace ideotype {
namespace {

constexpr std::size_t dimensions = sobol_dimensions + 4;

//! Integrates with 16 scrambled sequences of 1024 points each.
Estimate integrate(double (*function)(double, double)) {
    constexpr std::uint32_t points = 1024;
    std::vector<double> means;
    for (std::uint64_t seed = 1; seed <= 16; ++seed) {
        const SobolSequence sequence(seed, dimensions);
        double sum = 0;
        for (std::uint32_t i = 0; i < points; ++i)
            sum += function(sequence.at(i, 40), sequence.at(i, 200));
        means.push_back(sum / points);
    }
    return estimate(means);
}

TEST(SobolSequence, IntegrationIsMoreAccurateThanRandomNumbers) {
    const Estimate integral = integrate(
        [](double x, double y) { return std::sin(3 * x) * std::exp(y); });
    const double exact = (1 - std::cos(3)) / 3 * (std::exp(1) - 1);
    // The standard error of as many random points would be 0.005.
    EXPECT_LT(integral.standard_error, 1e-4);
    EXPECT_NEAR(integral.mean, exact, 4 * integral.standard_error);
}

TEST(SobolSequence, FurtherDimensionsAreRandomNumbers) {
    const SobolSequence sequence(3, dimensions);
    double sum = 0;
    constexpr std::uint32_t points = 4096;
    for (std::uint32_t i = 0; i < points; ++i) {
        const double last = sequence.at(i, dimensions - 1);
        ASSERT_NE(last, sequence.at(i, dimensions - 2));
        sum += last;
    }
    EXPECT_NEAR(sum / points, 0.5, 4 * std::sqrt(1. / 12 / points));
}

TEST(SobolSequence, OtherSeedsGiveOtherPoints) {
    EXPECT_NE(SobolSequence(1, dimensions).at(5, 0),
              SobolSequence(2, dimensions).at(5, 0));
}

}  // namespace
}  // namespace ideotype
