// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "ideotype/core/random.hpp"
#include "search/optimizer.hpp"

// Tests the distribution of children about their parents against the published
// densities of simulated binary crossover and polynomial mutation.

namespace ideotype {
namespace {

const Gene length{"length", "m", 0.4, 1.1, false, true};
const Gene azimuth{"azimuth", "deg", 0, 360, true, true};

using Distribution = std::function<double(double)>;

//! Pearson's statistic is computed over bins of equal probability.
constexpr std::size_t bins = 40;
//! The 99.9th percentile of chi-square with 39 degrees of freedom.
constexpr double critical = 72.05;

double chi_square(const std::vector<double>& values,
                  const Distribution& distribution) {
    std::vector<double> counts(bins);
    for (const double value : values) {
        const double p = distribution(value);
        EXPECT_GE(p, -1e-12) << value;
        EXPECT_LE(p, 1 + 1e-12) << value;
        ++counts[static_cast<std::size_t>(
            std::clamp(p * bins, 0.0, bins - 1.0))];
    }
    const double expected = static_cast<double>(values.size()) / bins;
    double sum = 0;
    for (const double count : counts)
        sum += (count - expected) * (count - expected) / expected;
    return sum;
}

//! Truncates a distribution at an upper bound and normalises it.
Distribution truncate(double bound, const Distribution& distribution) {
    return [=](double x) { return distribution(x) / distribution(bound); };
}

//! Wraps a distribution around a circle, from -period / 2 to period / 2: values
//! that differ by whole turns are the same.
Distribution wrap(double period, int turns, const Distribution& distribution) {
    double before = 0;
    for (int turn = -turns; turn <= turns; ++turn)
        before += distribution((turn - 0.5) * period);
    return [=](double x) {
        double sum = -before;
        for (int turn = -turns; turn <= turns; ++turn)
            sum += distribution(x + turn * period);
        return sum;
    };
}

//! Returns the distribution of the spread factor of simulated binary crossover
//! (Deb and Agrawal 1995, eq. 10 and 11: density (n + 1) / 2 b^n up to 1, (n +
//! 1) / 2 b^-(n + 2) beyond).
Distribution spread(double index) {
    return [=](double b) {
        if (b <= 0) return 0.0;
        return b <= 1 ? std::pow(b, index + 1) / 2
                      : 1 - std::pow(b, -(index + 1)) / 2;
    };
}

//! Returns the distribution of the length of a step of polynomial mutation to
//! either side, relative to the gene's range (Deb and Goyal 1996: density (n +
//! 1) (1 - d)^n for one side).
Distribution step(double index) {
    return [=](double d) {
        return 1 - std::pow(1 - std::clamp(d, 0.0, 1.0), index + 1);
    };
}

//! Breeds a generation from parents that have one gene, with these values.
std::vector<Candidate> make_children(const Gene& gene, const GaSettings& ga,
                                     const std::vector<double>& parents) {
    SearchSettings settings;
    settings.population = 200000;
    settings.ga = ga;
    settings.ga.elites = 0;
    settings.ga.tournament = 1;
    const auto optimizer =
        make_genetic_algorithm(settings, {{gene}, {parents[0]}}, 7);
    Population population;
    for (const double parent : parents)
        population.push_back(
            {{{parent}, Origin::random}, Status::done, {{1, 0}}});
    optimizer->tell(std::move(population));
    return optimizer->ask();
}

//! Distances of the two children of each crossed couple from the mean of their
//! parents, relative to half the distance between the parents. The distance
//! is positive for a child on the side of its parent.
struct Spreads {
    std::vector<double> below, above;
};

//! Returns whether the two children of a couple swap the crossed gene.
bool is_swapped(std::uint32_t slot) {
    RandomStream stream(7, Purpose::crossover, 1, slot);
    // The first three random numbers determine whether the couple is crossed,
    // whether the gene is crossed, and the spread factor.
    for (int i = 0; i < 3; ++i) stream.uniform();
    return stream.uniform() < 0.5;
}

Spreads cross_parents(const Gene& gene, double index, double low, double high) {
    GaSettings ga;
    ga.crossover_probability = 1;
    ga.crossover_index = index;
    ga.mutations_per_child = 0;
    const auto pool = make_children(gene, ga, {low, high});
    const double half = difference(gene, low, high) / 2;
    Spreads spreads;
    for (std::size_t i = 0; i < pool.size(); i += 2) {
        if (pool[i].parents[0] == pool[i].parents[1]) continue;
        const bool is_turned =
            (pool[i].parents[0] == 1) != is_swapped(static_cast<unsigned>(i));
        const double first = pool[is_turned ? i + 1 : i].genome[0];
        const double second = pool[is_turned ? i : i + 1].genome[0];
        // A gene that is not crossed is not swapped either.
        if (std::minmax(first, second) == std::minmax(low, high)) continue;
        spreads.below.push_back(difference(gene, first, low + half) / half);
        spreads.above.push_back(difference(gene, low + half, second) / half);
    }
    return spreads;
}

TEST(Crossover, HalfOfTheGenesOfDifferentParentsAreCrossed) {
    // Half of the 100000 couples consist of different parents: binomial(100000,
    // 1/4).
    const auto n = cross_parents(length, 15, 0.7, 0.8).above.size();
    EXPECT_NEAR(static_cast<double>(n), 25000, 4 * std::sqrt(1e5 * 3 / 16));
}

TEST(Crossover, CrossedGenesGoToEitherChild) {
    GaSettings ga;
    ga.crossover_probability = 1;
    ga.mutations_per_child = 0;
    const auto pool = make_children(length, ga, {0.7, 0.8});
    int kept = 0, swapped = 0;
    for (const Candidate& child : pool) {
        if (child.parents[0] == child.parents[1]) continue;
        const bool is_near_high = child.genome[0] > 0.75;
        ++(is_near_high == (child.parents[0] == 1) ? kept : swapped);
    }
    // Half of the genes are crossed, and half of these are swapped.
    EXPECT_NEAR(swapped / static_cast<double>(kept + swapped), 0.25, 0.01);
}

TEST(Crossover, SpreadFollowsThePublishedDensityFarFromBounds) {
    for (const double index : {2.0, 15.0}) {
        const Spreads spreads = cross_parents(length, index, 0.749, 0.751);
        EXPECT_LT(chi_square(spreads.below, spread(index)), critical) << index;
        EXPECT_LT(chi_square(spreads.above, spread(index)), critical) << index;
        // The test must reject a different index.
        EXPECT_GT(chi_square(spreads.above, spread(index + 1)), critical);
    }
}

TEST(Crossover, SpreadFollowsThePublishedDensityAtABound) {
    constexpr double index = 2;
    // The mean of the parents is 0.11 above the lower bound; half of their
    // distance is 0.09.
    const Spreads low = cross_parents(length, index, 0.42, 0.60);
    EXPECT_LT(chi_square(low.below, truncate(0.11 / 0.09, spread(index))),
              critical);
    EXPECT_LT(chi_square(low.above, truncate(0.59 / 0.09, spread(index))),
              critical);
    EXPECT_GT(chi_square(low.below, spread(index)), critical);

    // One parent is at the bound: children must not exceed it or accumulate at
    // it.
    const Spreads at = cross_parents(length, index, 1.0, 1.1);
    EXPECT_LT(chi_square(at.above, truncate(1, spread(index))), critical);
    EXPECT_LT(chi_square(at.below, truncate(0.65 / 0.05, spread(index))),
              critical);
}

TEST(Crossover, SpreadFollowsThePublishedDensityOnTheCircle) {
    // The mean of the parents is 5 deg. With index 0 many children wrap around
    // more than once.
    for (const double index : {0.0, 2.0, 15.0}) {
        const Spreads spreads = cross_parents(azimuth, index, 350, 20);
        const Distribution expected = wrap(360 / 15., 100, spread(index));
        EXPECT_LT(chi_square(spreads.below, expected), critical) << index;
        EXPECT_LT(chi_square(spreads.above, expected), critical) << index;
    }
    EXPECT_GT(chi_square(cross_parents(azimuth, 0, 350, 20).above, spread(0)),
              critical);
}

TEST(Mutation, GeneWithoutARangeDoesNotMutate) {
    const Gene fixed{"fixed", "m", 0.5, 0.5, false, true};
    GaSettings ga;
    ga.mutations_per_child = 1;
    for (const Candidate& child : make_children(fixed, ga, {0.5, 0.5}))
        ASSERT_EQ(child.genome[0], 0.5);
}

//! Returns steps of mutation relative to the gene's range.
std::vector<double> mutate_parent(const Gene& gene, double index,
                                  double parent) {
    GaSettings ga;
    ga.crossover_probability = 0;
    ga.mutations_per_child = 1;
    ga.mutation_index = index;
    std::vector<double> steps;
    for (const Candidate& child : make_children(gene, ga, {parent}))
        steps.push_back(difference(gene, parent, child.genome[0]) /
                        (gene.upper - gene.lower));
    return steps;
}

//! Returns the distribution of steps that are equally often negative and
//! positive, up to a length in each direction.
Distribution either_way(double index, double down, double up) {
    return [=](double d) {
        return d < 0 ? (1 - step(index)(-d) / step(index)(down)) / 2
                     : (1 + step(index)(d) / step(index)(up)) / 2;
    };
}

TEST(Mutation, StepsFollowThePublishedDensityUpToTheBounds) {
    for (const double index : {2.0, 20.0})
        for (const double room : {0.05, 0.3, 0.5, 0.9}) {
            const auto steps =
                mutate_parent(length, index, length.lower + room * 0.7);
            EXPECT_LT(chi_square(steps, either_way(index, room, 1 - room)),
                      critical)
                << index << " " << room;
            EXPECT_GT(chi_square(steps, either_way(index + 1, room, 1 - room)),
                      critical)
                << index << " " << room;
        }
}

TEST(Mutation, HalfOfTheStepsLeaveABound) {
    constexpr double index = 20;
    for (const double bound : {length.lower, length.upper}) {
        std::vector<double> inwards;
        for (const double way : mutate_parent(length, index, bound))
            if (way != 0) inwards.push_back(std::abs(way));
        EXPECT_NEAR(static_cast<double>(inwards.size()), 100000,
                    4 * std::sqrt(5e4));
        EXPECT_LT(chi_square(inwards, step(index)), critical);
    }
}

TEST(Mutation, StepsFollowThePublishedDensityOnTheCircle) {
    // The parent is 1 deg from north. With index 0 children are uniformly
    // distributed over the circle.
    for (const double index : {0.0, 2.0, 20.0}) {
        const auto steps = mutate_parent(azimuth, index, 1);
        const Distribution line = either_way(index, 1, 1);
        EXPECT_LT(chi_square(steps, wrap(1, 1, line)), critical) << index;
    }
    EXPECT_GT(chi_square(mutate_parent(azimuth, 2, 1), either_way(2, 1, 1)),
              critical);
}

}  // namespace
}  // namespace ideotype
