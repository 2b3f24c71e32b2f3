// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "ideotype/core/random.hpp"
#include "search/optimizer.hpp"

// Tests how far children are from their parents, against the densities that
// were published for simulated binary crossover and polynomial mutation.

namespace ideotype {
namespace {

const Gene length{"length", "m", 0.4, 1.1, false, true};
const Gene azimuth{"azimuth", "deg", 0, 360, true, true};

using Distribution = std::function<double(double)>;

//! Pearson's statistic of values in bins of equal probability.
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

//! Returns the part of a distribution below a bound, normalised to 1.
Distribution up_to(double bound, const Distribution& distribution) {
    return [=](double x) { return distribution(x) / distribution(bound); };
}

//! Returns a distribution on a circle, from -period / 2 to period / 2: values
//! on a line that whole turns separate fall together.
Distribution on_circle(double period, int turns,
                       const Distribution& distribution) {
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

//! Returns all children of parents with these values of one gene.
std::vector<Candidate> children(const Gene& gene, const GaSettings& ga,
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

//! Distances of the two children of each crossed couple from the couple's mean,
//! relative to half of the distance between the parents, the smaller first:
//! positive on the side where the child belongs.
struct Spreads {
    std::vector<double> below, above;
};

//! Returns whether the two children of a couple swap the crossed gene.
bool is_swapped(std::uint32_t slot) {
    RandomStream stream(7, Purpose::crossover, 1, slot);
    // Random numbers decide whether the couple is crossed, whether the gene is
    // crossed, and how far.
    for (int i = 0; i < 3; ++i) stream.uniform();
    return stream.uniform() < 0.5;
}

Spreads crossed(const Gene& gene, double index, double low, double high) {
    GaSettings ga;
    ga.crossover_probability = 1;
    ga.crossover_index = index;
    ga.mutations_per_child = 0;
    const auto all = children(gene, ga, {low, high});
    const double half = difference(gene, low, high) / 2;
    Spreads spreads;
    for (std::size_t i = 0; i < all.size(); i += 2) {
        if (all[i].parents[0] == all[i].parents[1]) continue;
        const bool is_turned =
            (all[i].parents[0] == 1) != is_swapped(static_cast<unsigned>(i));
        const double first = all[is_turned ? i + 1 : i].genome[0];
        const double second = all[is_turned ? i : i + 1].genome[0];
        // The gene is not crossed, and therefore not swapped.
        if (std::minmax(first, second) == std::minmax(low, high)) continue;
        spreads.below.push_back(difference(gene, first, low + half) / half);
        spreads.above.push_back(difference(gene, low + half, second) / half);
    }
    return spreads;
}

TEST(Crossover, HalfOfTheGenesOfUnlikeParentsAreCrossed) {
    // Half of 100000 couples have unlike parents: binomial(100000, 1/4).
    const auto n = crossed(length, 15, 0.7, 0.8).above.size();
    EXPECT_NEAR(static_cast<double>(n), 25000, 4 * std::sqrt(1e5 * 3 / 16));
}

TEST(Crossover, CrossedGenesGoToEitherChild) {
    GaSettings ga;
    ga.crossover_probability = 1;
    ga.mutations_per_child = 0;
    const auto all = children(length, ga, {0.7, 0.8});
    int own = 0, other = 0;
    for (const Candidate& each : all) {
        if (each.parents[0] == each.parents[1]) continue;
        const bool is_near_high = each.genome[0] > 0.75;
        ++(is_near_high == (each.parents[0] == 1) ? own : other);
    }
    // Half of the genes are crossed, and half of the crossed ones swapped.
    EXPECT_NEAR(other / static_cast<double>(own + other), 0.25, 0.01);
}

TEST(Crossover, SpreadsAsPublishedFarFromBounds) {
    for (const double index : {2.0, 15.0}) {
        const Spreads found = crossed(length, index, 0.749, 0.751);
        EXPECT_LT(chi_square(found.below, spread(index)), critical) << index;
        EXPECT_LT(chi_square(found.above, spread(index)), critical) << index;
        // The test distinguishes another index.
        EXPECT_GT(chi_square(found.above, spread(index + 1)), critical);
    }
}

TEST(Crossover, SpreadsAsPublishedUpToABound) {
    constexpr double index = 2;
    // The mean is 0.11 above the lower bound; half of the distance is 0.09.
    const Spreads low = crossed(length, index, 0.42, 0.60);
    EXPECT_LT(chi_square(low.below, up_to(0.11 / 0.09, spread(index))),
              critical);
    EXPECT_LT(chi_square(low.above, up_to(0.59 / 0.09, spread(index))),
              critical);
    EXPECT_GT(chi_square(low.below, spread(index)), critical);

    // A parent stands at the bound: children do not pass the bound, nor gather
    // there.
    const Spreads at = crossed(length, index, 1.0, 1.1);
    EXPECT_LT(chi_square(at.above, up_to(1, spread(index))), critical);
    EXPECT_LT(chi_square(at.below, up_to(0.65 / 0.05, spread(index))),
              critical);
}

TEST(Crossover, SpreadsAsPublishedOnTheCircle) {
    // The couple's mean is 5 deg; with index 0 many children go round more than
    // once.
    for (const double index : {0.0, 2.0, 15.0}) {
        const Spreads found = crossed(azimuth, index, 350, 20);
        const Distribution expected = on_circle(360 / 15., 100, spread(index));
        EXPECT_LT(chi_square(found.below, expected), critical) << index;
        EXPECT_LT(chi_square(found.above, expected), critical) << index;
    }
    EXPECT_GT(chi_square(crossed(azimuth, 0, 350, 20).above, spread(0)),
              critical);
}

TEST(Mutation, LeavesAGeneWithoutARangeAsItIs) {
    const Gene fixed{"fixed", "m", 0.5, 0.5, false, true};
    GaSettings ga;
    ga.mutations_per_child = 1;
    for (const Candidate& each : children(fixed, ga, {0.5, 0.5}))
        ASSERT_EQ(each.genome[0], 0.5);
}

//! Returns steps of mutation relative to the gene's range.
std::vector<double> mutated(const Gene& gene, double index, double parent) {
    GaSettings ga;
    ga.crossover_probability = 0;
    ga.mutations_per_child = 1;
    ga.mutation_index = index;
    std::vector<double> steps;
    for (const Candidate& child : children(gene, ga, {parent}))
        steps.push_back(difference(gene, parent, child.genome[0]) /
                        (gene.upper - gene.lower));
    return steps;
}

//! Returns the distribution of steps that go down and up equally often, up to a
//! length.
Distribution either_way(double index, double down, double up) {
    return [=](double d) {
        return d < 0 ? (1 - step(index)(-d) / step(index)(down)) / 2
                     : (1 + step(index)(d) / step(index)(up)) / 2;
    };
}

TEST(Mutation, StepsAsPublishedUpToTheBounds) {
    for (const double index : {2.0, 20.0})
        for (const double room : {0.05, 0.3, 0.5, 0.9}) {
            const auto steps =
                mutated(length, index, length.lower + room * 0.7);
            EXPECT_LT(chi_square(steps, either_way(index, room, 1 - room)),
                      critical)
                << index << " " << room;
            EXPECT_GT(chi_square(steps, either_way(index + 1, room, 1 - room)),
                      critical)
                << index << " " << room;
        }
}

TEST(Mutation, AtABoundHalfOfTheStepsLeaveIt) {
    constexpr double index = 20;
    for (const double bound : {length.lower, length.upper}) {
        std::vector<double> inwards;
        for (const double way : mutated(length, index, bound))
            if (way != 0) inwards.push_back(std::abs(way));
        EXPECT_NEAR(static_cast<double>(inwards.size()), 100000,
                    4 * std::sqrt(5e4));
        EXPECT_LT(chi_square(inwards, step(index)), critical);
    }
}

TEST(Mutation, StepsAsPublishedOnTheCircle) {
    // The parent is one degree from north; with index 0 children are even all
    // around.
    for (const double index : {0.0, 2.0, 20.0}) {
        const auto steps = mutated(azimuth, index, 1);
        const Distribution line = either_way(index, 1, 1);
        EXPECT_LT(chi_square(steps, on_circle(1, 1, line)), critical) << index;
    }
    EXPECT_GT(chi_square(mutated(azimuth, 2, 1), either_way(2, 1, 1)),
              critical);
}

}  // namespace
}  // namespace ideotype
