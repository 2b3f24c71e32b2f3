// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "ideotype/core/estimate.hpp"
#include "ideotype/core/random.hpp"

namespace ideotype {

TEST(Estimate, IsTheMeanAndItsStandardError) {
    const std::vector<double> replicates{1, 2, 3, 4};
    const Estimate x = estimate(replicates);
    EXPECT_DOUBLE_EQ(x.mean, 2.5);
    EXPECT_DOUBLE_EQ(x.standard_error, std::sqrt(5.0 / 12));
}

TEST(Estimate, OfEqualReplicatesIsExact) {
    const std::vector<double> replicates{0.25, 0.25, 0.25};
    const Estimate x = estimate(replicates);
    EXPECT_EQ(x.mean, 0.25);
    EXPECT_EQ(x.standard_error, 0);
}

TEST(Estimate, KnowsNoErrorFromASingleReplicate) {
    const std::vector<double> replicates{7};
    EXPECT_EQ(estimate(replicates).mean, 7);
    EXPECT_TRUE(std::isnan(estimate(replicates).standard_error));
}

TEST(Estimate, OfNothingIsNotANumber) {
    EXPECT_TRUE(std::isnan(estimate({}).mean));
    EXPECT_TRUE(std::isnan(estimate({}).standard_error));
}

TEST(Estimate, KeepsItsDigitsFarFromZero) {
    const std::vector<double> replicates{1e9 + 1, 1e9 + 2, 1e9 + 3};
    EXPECT_DOUBLE_EQ(estimate(replicates).standard_error, std::sqrt(1.0 / 3));
}

TEST(Estimate, ItsErrorIsTheSpreadOfTheMean) {
    // 2,000 means of 8 uniform numbers scatter by sqrt(1 / 12 / 8).
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

TEST(Scaled, ScalesTheErrorByTheMagnitude) {
    const Estimate x = scaled({3, 0.5}, -2);
    EXPECT_EQ(x.mean, -6);
    EXPECT_EQ(x.standard_error, 1);
}

}  // namespace ideotype
