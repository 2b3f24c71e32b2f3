// SPDX-License-Identifier: Apache-2.0
#include <set>

#include <gtest/gtest.h>

#include "ideotype/core/estimate.hpp"
#include "ideotype/light/sampler.hpp"

namespace ideotype {
namespace {

TEST(Sampler, EveryDimensionIsStratified) {
    constexpr std::uint32_t n = 1024;
    PathSampler sampler(5, 3, 2, 1);
    std::vector<std::set<unsigned>> cells(path_dimensions);
    for (std::uint32_t path = 0; path < n; ++path) {
        sampler.begin(path);
        for (auto& seen : cells)
            seen.insert(static_cast<unsigned>(sampler.next() * n));
    }
    for (const auto& seen : cells) EXPECT_EQ(seen.size(), n);
}

TEST(Sampler, ThePlaneIsStratifiedInBoxesOfAnyShape) {
    constexpr std::uint32_t n = 1024;
    PathSampler sampler(5, 3, 2, 1);
    for (const unsigned columns : {1u, 8u, 32u, 256u, 1024u}) {
        std::set<unsigned> boxes;
        for (std::uint32_t path = 0; path < n; ++path) {
            sampler.begin(path);
            const auto i = static_cast<unsigned>(sampler.next() * columns);
            const auto j = static_cast<unsigned>(sampler.next() * n / columns);
            boxes.insert(i * (n / columns) + j);
        }
        EXPECT_EQ(boxes.size(), n) << columns;
    }
}

TEST(Sampler, NumbersAreUniformAlsoBeyondTheNet) {
    constexpr std::uint32_t n = 4096;
    PathSampler sampler(1, 0, 0, 0);
    std::vector<double> means(40);
    for (std::uint32_t path = 0; path < n; ++path) {
        sampler.begin(path);
        for (double& mean : means) {
            const double x = sampler.next();
            ASSERT_GE(x, 0);
            ASSERT_LT(x, 1);
            mean += x / n;
        }
    }
    for (const double mean : means) EXPECT_NEAR(mean, 0.5, 0.02);
}

TEST(Sampler, RandomisationsAndSourcesDiffer) {
    std::set<double> seen;
    for (PathSampler sampler :
         {PathSampler(1, 0, 0, 0), PathSampler(1, 0, 1, 0),
          PathSampler(1, 1, 0, 0), PathSampler(1, 0, 0, 1)}) {
        sampler.begin(9);
        seen.insert(sampler.next());
    }
    EXPECT_EQ(seen.size(), 4u);
}

}  // namespace
}  // namespace ideotype
