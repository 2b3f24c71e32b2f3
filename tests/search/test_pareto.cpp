// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "search/order.hpp"

namespace ideotype {
namespace {

const std::vector<Sense> senses{Sense::maximise, Sense::minimise};

Individual plant(double light, double area, double violation = 0) {
    return {{}, Status::done, {{light, 0}, {area, 0}}, violation};
}

TEST(Pareto, FrontsAreNonDominatedWithoutEarlierFronts) {
    const Population population{plant(10, 5), plant(8, 3),  plant(9, 5),
                                plant(8, 4),  plant(10, 5), plant(7, 6)};
    EXPECT_EQ(fronts(population, senses),
              (std::vector<std::size_t>{0, 0, 1, 1, 0, 2}));
}

TEST(Pareto, InfeasiblePlantsComeAfterFeasibleOnes) {
    Population population{plant(99, 1, 0.1), plant(5, 9), plant(99, 1, 0.01),
                          plant(99, 1)};
    population[3].status = Status::failed;
    EXPECT_EQ(fronts(population, senses),
              (std::vector<std::size_t>{2, 0, 1, 3}));
    EXPECT_EQ(places(population, senses),
              (std::vector<std::size_t>{2, 0, 1, 3}));
}

TEST(Pareto, LeastCrowdedOfAFrontComeFirst) {
    const Population population{plant(0, 0), plant(1, 1), plant(2, 2),
                                plant(9, 9), plant(10, 10)};
    const auto distance = crowding(population, {0, 1, 2, 3, 4}, 2);
    constexpr double endless = std::numeric_limits<double>::infinity();
    EXPECT_EQ(distance[0], endless);
    EXPECT_DOUBLE_EQ(distance[1], 0.2);
    EXPECT_DOUBLE_EQ(distance[2], 0.8);
    EXPECT_DOUBLE_EQ(distance[3], 0.8);
    EXPECT_EQ(distance[4], endless);
    EXPECT_EQ(places(population, senses),
              (std::vector<std::size_t>{0, 4, 2, 2, 0}));
    EXPECT_EQ(ranking(population, senses),
              (std::vector<std::uint32_t>{0, 4, 2, 3, 1}));
}

TEST(Pareto, SingleObjectiveRanksWithoutFronts) {
    const Population population{plant(1, 0), plant(3, 0), plant(2, 0),
                                plant(3, 0)};
    EXPECT_EQ(places(population, {Sense::maximise}),
              (std::vector<std::size_t>{3, 0, 2, 0}));
}

}  // namespace
}  // namespace ideotype
