// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "ideotype/core/estimate.hpp"
#include "ideotype/core/random.hpp"

namespace ideotype {

TEST(Estimate, MeanAndStandardErrorAreEstimated) {
    const std::vector<double> replicates{1, 2, 3, 4};
    const Estimate x = estimate(replicates);
    EXPECT_DOUBLE_EQ(x.mean, 2.5);
    EXPECT_DOUBLE_EQ(x.standard_error, std::sqrt(5.0 / 12));
}

TEST(Estimate, EqualReplicatesHaveNoError) {
    const std::vector<double> replicates{0.25, 0.25, 0.25};
    const Estimate x = estimate(replicates);
    EXPECT_EQ(x.mean, 0.25);
    EXPECT_EQ(x.standard_error, 0);
}

TEST(Estimate, SingleReplicateHasUnknownError) {
    const std::vector<double> replicates{7};
    EXPECT_EQ(estimate(replicates).mean, 7);
    EXPECT_TRUE(std::isnan(estimate(replicates).standard_error));
}

TEST(Estimate, EmptySampleIsNaN) {
    EXPECT_TRUE(std::isnan(estimate({}).mean));
    EXPECT_TRUE(std::isnan(estimate({}).standard_error));
}

TEST(Estimate, PrecisionIsKeptFarFromZero) {
    const std::vector<double> replicates{1e9 + 1, 1e9 + 2, 1e9 + 3};
    EXPECT_DOUBLE_EQ(estimate(replicates).standard_error, std::sqrt(1.0 / 3));
}

TEST(Estimate, StandardErrorIsTheSpreadOfTheMean) {
    // The standard deviation of 2,000 means of 8 uniform numbers is sqrt(1 / 12
    // / 8).
    RandomStream random(1, Purpose::jitter);
    double squared_errors = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<double> replicates(8);
        for (double& x : replicates) x = random.uniform();
        const double error = estimate(replicates).standard_error;
        squared_errors += error * error / 2000;
    }
    EXPECT_NEAR(squared_errors * 96, 1, 0.05);
}

namespace {

double root_mean_square(const std::vector<double>& values) {
    double squares = 0;
    for (const double x : values) squares += x * x;
    return std::sqrt(squares / static_cast<double>(values.size()));
}

}  // namespace

TEST(RelativeGain, StandardErrorIsThatOfTheRatio) {
    // The mean of the baseline is 0.171 and that of a plant is four times as
    // large. They share part of their noise, like net carbon balances at 15 x 3
    // inches.
    RandomStream random(2, Purpose::jitter);
    const auto noise = [&] { return random.uniform() - 0.5; };
    std::vector<double> gains, paired, independent;
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<double> before(16), after(16);
        for (std::size_t i = 0; i < before.size(); ++i) {
            const double common = 0.016 * noise();
            before[i] = 0.171 + common + 0.008 * noise();
            after[i] = 0.728 + common + 0.008 * noise();
        }
        const Randomisations a{estimate(before), before};
        const Randomisations b{estimate(after), after};
        const Estimate gain = relative_gain(a, b);
        gains.push_back(gain.mean - 100 * (0.728 / 0.171 - 1));
        paired.push_back(gain.standard_error);
        independent.push_back(
            relative_gain({a.figure, {}}, {b.figure, {}}).standard_error);
        // A standard error without the uncertainty of the divisor would be too
        // small.
        EXPECT_GT(gain.standard_error,
                  2 * 100 / a.figure.mean * difference(a, b).standard_error);
    }
    const double spread = root_mean_square(gains);
    EXPECT_NEAR(root_mean_square(paired) / spread, 1, 0.05);
    EXPECT_GT(root_mean_square(independent) / spread, 1.1);
}

TEST(RelativeGain, GainOverANegativeValueIsRelativeToItsMagnitude) {
    const Estimate gain = relative_gain({{-2, 0.1}, {}}, {{-1, 0}, {}});
    EXPECT_DOUBLE_EQ(gain.mean, -50);
    EXPECT_DOUBLE_EQ(gain.standard_error, 2.5);
    EXPECT_TRUE(std::isnan(relative_gain({{0, 0}, {}}, {{1, 0}, {}}).mean));
}

TEST(RelativeGain, RandomisationsArePairedOnlyIfBothAreKnown) {
    const double nan = std::nan("");
    const std::vector<double> unknown{nan, nan}, known{1, 1.2}, more{1, 2, 3};
    const Randomisations b{{2, 0.3}, known};
    for (const std::vector<double>& other : {unknown, more})
        EXPECT_DOUBLE_EQ(difference({{1, 0.4}, other}, b).standard_error, 0.5);
}

TEST(Scaled, ErrorIsScaledByTheMagnitude) {
    const Estimate x = scaled({3, 0.5}, -2);
    EXPECT_EQ(x.mean, -6);
    EXPECT_EQ(x.standard_error, 1);
}

}  // namespace ideotype
