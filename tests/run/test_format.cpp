// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include <gtest/gtest.h>

#include "run/progress.hpp"
#include "run/summary.hpp"

namespace ideotype {
namespace {

TEST(Format, ShowsTwoDigitsOfTheStandardError) {
    EXPECT_EQ(format({11.12345, 0.0234}), "11.123 +- 0.023");
    EXPECT_EQ(format({1234.5, 67}), "1234 +- 67");
    EXPECT_EQ(format({3, 0}), "3");
    EXPECT_EQ(format({3.5, std::numeric_limits<double>::quiet_NaN()}), "3.5");
    EXPECT_EQ(format({std::numeric_limits<double>::quiet_NaN(), 1}), "unknown");
}

TEST(Format, ZerosAndSmallNumbersHaveNoTailOfDigits) {
    EXPECT_EQ(format({0, 0}), "0");
    EXPECT_EQ(format({-0., 0}), "0");
    EXPECT_EQ(format({3e-16, 0}), "0");
    EXPECT_EQ(format({-2e-15, 4e-15}), "0");
    EXPECT_EQ(format({0.40173143865, 3e-17}), "0.401731439");
    EXPECT_EQ(format({-7.7e-7, 7.6e-7}), "-7.7e-07 +- 7.6e-07");
    EXPECT_EQ(format({2.5e-5, 0}), "2.5e-05");
    EXPECT_EQ(format({-1e-9, 0.0023}), "0.0000 +- 0.0023");
    EXPECT_EQ(format({0, 0.5}), "0.00 +- 0.50");
    EXPECT_EQ(format({0.85613542, 7.7e-7}), "0.85613542 +- 0.00000077");
}

//! A job in the middle of its work.
JobProgress far_progress() {
    JobProgress job;
    job.cases = 40;
    job.ended = 12;
    job.in_flight = 3;
    job.name = "bondville_season_762x152_all_r1";
    job.complete = 7;
    job.generations = 200;
    job.best = Estimate{0.85613, 0.0015};
    job.unit = "mol m-2 day-1";
    job.evaluations_per_second = 86.73;
    job.left = 3725;
    return job;
}

TEST(ProgressLine, FitsItsWidthAndKeepsWhatMattersMost) {
    const JobProgress job = far_progress();
    EXPECT_EQ(progress_line(job, 59),
              "12 of 40 cases done, 1:02:05 left, best 0.8561");
    EXPECT_EQ(progress_line(job, 79),
              "12 of 40 cases done, 1:02:05 left, best 0.8561 mol m-2 day-1");
    EXPECT_EQ(progress_line(job, 99),
              "12 of 40 cases done, 1:02:05 left, 7 of 200 generations, best "
              "0.8561 +- 0.0015 mol m-2 day-1");
    EXPECT_EQ(progress_line(job, 199),
              "12 of 40 cases done, 3 in flight, 1:02:05 left, 86.7 "
              "evaluations/s, bondville_season_762x152_all_r1, 7 of 200 "
              "generations, best 0.8561 +- 0.0015 mol m-2 day-1");
}

TEST(ProgressLine, NeverWrapsAndAlwaysHasTheBest) {
    JobProgress job = far_progress();
    job.hypervolume = Estimate{1.25, 0.01};
    for (std::size_t columns = 0; columns <= 240; ++columns) {
        const std::string line = progress_line(job, columns);
        EXPECT_LE(line.size(), columns);
        if (columns < 47) continue;
        for (const char* part : {"12 of 40 cases", "1:02:05 left", "0.8561"})
            EXPECT_NE(line.find(part), std::string::npos) << line;
    }
}

TEST(ProgressLine, OfOneCaseHasNoCount) {
    JobProgress job = far_progress();
    job.cases = job.in_flight = 1;
    job.ended = 0;
    job.best.reset();
    job.left.reset();
    EXPECT_EQ(progress_line(job, 50), "7 of 200 generations");
}

TEST(Format, DurationsReadLikeAClock) {
    EXPECT_EQ(format_duration(3.2), "0:03");
    EXPECT_EQ(format_duration(125), "2:05");
    EXPECT_EQ(format_duration(3725), "1:02:05");
}

TEST(Format, DailyEnergyComesInThreeUnits) {
    EXPECT_EQ(format_daily({10, 0.5}),
              "10.00 +- 0.50 MJ m-2 day-1 = 45.7 +- 2.3 mol m-2 day-1 = "
              "11.24 +- 0.56 MWh acre-1 day-1");
}

}  // namespace
}  // namespace ideotype
