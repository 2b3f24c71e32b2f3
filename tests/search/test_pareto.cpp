#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "ideotype/search/genetic_algorithm.hpp"
#include "ideotype/search/pareto.hpp"

namespace ideotype {
namespace {

const std::vector<Sense> senses{Sense::maximise, Sense::minimise};

Individual plant(double light, double area, double violation = 0) {
    return {{}, Status::done, {{light, 0}, {area, 0}}, violation};
}

TEST(Pareto, FrontsAreWhatIsLeftWithoutTheFrontsBefore) {
    const Population population{plant(10, 5), plant(8, 3),  plant(9, 5),
                                plant(8, 4),  plant(10, 5), plant(7, 6)};
    EXPECT_EQ(fronts(population, senses),
              (std::vector<std::size_t>{0, 0, 1, 1, 0, 2}));
}

TEST(Pareto, PlantsThatFailConstraintsComeAfterAllThatMeetThem) {
    Population population{plant(99, 1, 0.1), plant(5, 9), plant(99, 1, 0.01),
                          plant(99, 1)};
    population[3].status = Status::failed;
    EXPECT_EQ(fronts(population, senses),
              (std::vector<std::size_t>{2, 0, 1, 3}));
    EXPECT_EQ(places(population, senses),
              (std::vector<std::size_t>{2, 0, 1, 3}));
}

TEST(Pareto, TheLeastCrowdedOfAFrontComeFirst) {
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

TEST(Pareto, OneObjectiveNeedsNoFronts) {
    const Population population{plant(1, 0), plant(3, 0), plant(2, 0),
                                plant(3, 0)};
    EXPECT_EQ(places(population, {Sense::maximise}),
              (std::vector<std::size_t>{3, 0, 2, 0}));
}

// Half of each generation are the best of the last one, which alone are
// parents.
TEST(Nsga2, CarriesHalfOfAGenerationOver) {
    SearchSettings settings;
    settings.optimizer = OptimizerKind::nsga2;
    settings.population = 40;
    const GeneSpace genes(3, {"x", "1", 0, 1, false, true});
    const auto search = std::make_unique<GeneticAlgorithm>(
        settings, SearchSpace{genes, {0.5, 0.5, 0.5}, senses}, 1);
    Population rows;
    for (const Candidate& each : search->ask())
        rows.push_back({each,
                        Status::done,
                        {{each.genome[0], 0}, {each.genome[1], 0}},
                        0});
    search->tell(rows);
    const auto next = search->ask();
    ASSERT_EQ(next.size(), 40U);
    const auto order = ranking(rows, senses);
    for (std::size_t i = 0; i < 20; ++i) {
        EXPECT_EQ(next[i].origin, Origin::elite);
        EXPECT_EQ(next[i].genome, rows[order[i]].candidate.genome);
    }
    const std::set<std::int64_t> parents(order.begin(), order.begin() + 20);
    for (std::size_t i = 20; i < 40; ++i) {
        EXPECT_EQ(next[i].origin, Origin::child);
        EXPECT_EQ(parents.count(next[i].parents[0]), 1U);
    }
}

}  // namespace
}  // namespace ideotype
