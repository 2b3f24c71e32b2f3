// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "ideotype/core/random.hpp"
#include "search/optimizer.hpp"

namespace ideotype {
namespace {

const GeneSpace genes{{"length", "m", 0.4, 1.1, false, true},
                      {"azimuth", "deg", 0, 360, true, true},
                      {"width", "m", 0.05, 0.14, false, false}};
const Genome baseline{0.7, 90, 0.08};

SearchSettings small() {
    SearchSettings settings;
    settings.population = 41;
    settings.ga.elites = 3;
    settings.ga.mutations_per_child = 1;
    return settings;
}

//! Evaluates a generation; the objective is the first gene.
Population evaluate(const std::vector<Candidate>& candidates) {
    Population population;
    for (const Candidate& c : candidates)
        population.push_back({c, Status::done, {{c.genome[0], 0.01}}});
    return population;
}

std::vector<Candidate> list_candidates(const Population& population) {
    std::vector<Candidate> candidates;
    for (const Individual& i : population) candidates.push_back(i.candidate);
    return candidates;
}

//! Returns the proposals of a new optimizer for a generation after earlier
//! generations that all equal `parents`.
std::vector<Candidate> propose_generation(const SearchSettings& settings,
                                          std::uint64_t seed,
                                          std::uint32_t generation,
                                          const Population& parents) {
    const auto optimizer =
        make_genetic_algorithm(settings, SearchSpace{genes, baseline}, seed);
    for (std::uint32_t g = 0; g < generation; ++g) optimizer->tell(parents);
    return optimizer->ask();
}

Population first_generation() {
    return evaluate(propose_generation(small(), 7, 0, {}));
}

//! Returns the evaluated generations of a search.
std::vector<Population> run_search(std::size_t generations) {
    const auto optimizer =
        make_genetic_algorithm(small(), SearchSpace{genes, baseline}, 7);
    std::vector<Population> history;
    while (history.size() < generations) {
        history.push_back(evaluate(optimizer->ask()));
        optimizer->tell(history.back());
    }
    return history;
}

TEST(GeneticAlgorithm, FirstGenerationIsTheBaselineAndRandomGenomes) {
    const Population first = first_generation();
    ASSERT_EQ(first.size(), 41u);
    EXPECT_EQ(first[0].candidate.genome, baseline);
    EXPECT_EQ(first[0].candidate.origin, Origin::baseline);
    std::set<double> lengths;
    for (const Individual& i : first) {
        lengths.insert(i.candidate.genome[0]);
        EXPECT_EQ(i.candidate.parents, (std::array{no_parent, no_parent}));
    }
    EXPECT_EQ(lengths.size(), 41u);
    EXPECT_EQ(first[40].candidate.origin, Origin::random);
}

TEST(GeneticAlgorithm, ProposalsAreAPureFunctionOfSeedGenerationAndParents) {
    const Population parents = first_generation();
    const auto genomes = [&](std::uint64_t seed, std::uint32_t generation) {
        std::vector<Genome> list;
        for (const Candidate& c :
             propose_generation(small(), seed, generation, parents))
            list.push_back(c.genome);
        return list;
    };
    EXPECT_EQ(genomes(7, 1), genomes(7, 1));
    EXPECT_NE(genomes(7, 1), genomes(8, 1));
    EXPECT_NE(genomes(7, 1), genomes(7, 2));
}

// Contract C3: any change in the order of random numbers or of operations would
// change the children. Update these values only with an intended change of this
// order.
TEST(GeneticAlgorithm, ChildrenOfASeedStayTheSame) {
    struct Child {
        std::array<std::int64_t, 2> parents;
        double length, azimuth;
    };
    const Child expected[]{{{35, 38}, 1.0267507584486153, 45.434863289934583},
                           {{38, 35}, 1.0199458617718744, 346.22667339680328},
                           {{7, 33}, 1.0314798684108246, 284.89665807475541},
                           {{33, 7}, 0.79891001066969458, 309.63058275235636},
                           {{17, 5}, 0.74890761955041629, 238.39932495100061},
                           {{5, 17}, 0.48206519316227509, 337.73144000148335},
                           {{24, 0}, 0.90261582956160313, 107.82840498340637},
                           {{0, 24}, 0.68144722408303704, 88.834526711629408},
                           {{19, 11}, 1.0258171986935358, 180.32462170641767}};
    const auto children = propose_generation(small(), 7, 1, first_generation());
    std::size_t slot = 3;
    for (const Child& child : expected) {
        EXPECT_EQ(children[slot].parents, child.parents) << slot;
        EXPECT_EQ(children[slot].genome,
                  (Genome{child.length, child.azimuth, baseline[2]}))
            << slot;
        ++slot;
    }
}

// Contract C3: a resumed case continues as if it had not been interrupted.
TEST(GeneticAlgorithm, ResumedSearchProposesTheSame) {
    const std::vector<Population> history = run_search(12);
    for (std::size_t g = 0; g < history.size(); ++g) {
        const auto optimizer =
            make_genetic_algorithm(small(), SearchSpace{genes, baseline}, 7);
        for (std::size_t k = 0; k < g; ++k) optimizer->tell(history[k]);
        EXPECT_EQ(list_candidates(history[g]), optimizer->ask()) << g;
        EXPECT_EQ(optimizer->ask(), optimizer->ask()) << g;
    }
}

TEST(GeneticAlgorithm, GenerationsMayHaveAnySize) {
    const auto optimizer =
        make_genetic_algorithm(small(), SearchSpace{genes, baseline}, 7);
    std::int64_t first = 0;
    for (const std::int64_t size : {17, 41, 3, 60}) {
        Population rows = first_generation();
        rows.resize(static_cast<std::size_t>(size), rows.back());
        optimizer->tell(rows);
        const auto candidates = optimizer->ask();
        EXPECT_EQ(candidates.size(), 41u);
        for (const Candidate& c : candidates) {
            EXPECT_GE(c.parents[0], first);
            for (const std::int64_t parent : c.parents)
                EXPECT_LT(parent, first + size);
        }
        first += size;
    }
}

TEST(GeneticAlgorithm, ChildrenStayInsideBounds) {
    for (const Population& generation : run_search(60))
        for (const Individual& i : generation) {
            EXPECT_GE(i.candidate.genome[0], 0.4);
            EXPECT_LE(i.candidate.genome[0], 1.1);
            EXPECT_GE(i.candidate.genome[1], 0);
            EXPECT_LT(i.candidate.genome[1], 360);
        }
}

TEST(GeneticAlgorithm, GenesThatAreNotFreeKeepTheBaseline) {
    for (const Population& generation : run_search(10))
        for (const Individual& i : generation)
            EXPECT_EQ(i.candidate.genome[2], baseline[2]);
}

TEST(GeneticAlgorithm, ElitesAreTheBestDistinctParents) {
    Population parents = first_generation();
    parents[5].candidate.genome[0] = parents[9].candidate.genome[0] = 1.09;
    parents[5].candidate.genome[1] = parents[9].candidate.genome[1] = 11;
    parents[5].objectives = parents[9].objectives = {{1.09, 0}};
    const auto children = propose_generation(small(), 7, 1, parents);
    EXPECT_EQ(children[0].genome, parents[5].candidate.genome);
    EXPECT_EQ(children[0].parents[0], 5);
    EXPECT_NE(children[1].genome, children[0].genome);
    EXPECT_EQ(children[2].origin, Origin::elite);
    EXPECT_EQ(children[3].origin, Origin::child);
}

TEST(GeneticAlgorithm, ParentsStayUntilChildrenDominateThem) {
    SearchSettings settings = small();
    settings.optimizer = OptimizerKind::nsga2;
    settings.population = 20;
    const auto search = make_genetic_algorithm(
        settings, {genes, baseline, {Sense::maximise, Sense::minimise}}, 7);
    // Plants of equal level do not dominate each other, and dominate all plants
    // of lower levels.
    const auto tell = [&](double level) {
        Population rows;
        for (const Candidate& candidate : search->ask()) {
            const auto slot = static_cast<double>(rows.size());
            rows.push_back({candidate,
                            Status::done,
                            {{slot + 100 * level, 0}, {slot - 100 * level, 0}},
                            0});
        }
        search->tell(rows);
    };
    tell(1);
    tell(0);
    ASSERT_EQ(search->best(20).size(), 20u);
    for (const Candidate& candidate : search->best(20))
        EXPECT_LT(candidate.parents[0], 20);
    for (const Candidate& candidate : search->ask()) {
        EXPECT_EQ(candidate.origin, Origin::child);
        EXPECT_LT(candidate.parents[0], 20);
    }
    tell(2);
    for (const Candidate& candidate : search->best(20))
        EXPECT_GE(candidate.parents[0], 40);
}

TEST(GeneticAlgorithm, SelectionImprovesThePopulation) {
    const Population last = run_search(40).back();
    double mean = 0;
    for (const Individual& i : last) mean += i.objectives[0].mean / 41;
    EXPECT_GT(mean, 1.05);
}

TEST(GeneticAlgorithm, FailedParentIsNeverPreferred) {
    Population parents = first_generation();
    for (std::size_t i = 1; i < parents.size(); ++i)
        parents[i].status = Status::failed;
    SearchSettings settings = small();
    settings.ga.tournament = 200;
    const auto children = propose_generation(settings, 7, 1, parents);
    EXPECT_EQ(children[0].genome, baseline);
    for (std::size_t i = 1; i < children.size(); ++i)
        EXPECT_EQ(children[i].parents[0], 0);
}

TEST(GeneticAlgorithm, AzimuthCrossesNorthAlongTheShorterArc) {
    EXPECT_DOUBLE_EQ(difference(genes[1], 359, 1), 2);
    EXPECT_DOUBLE_EQ(difference(genes[1], 1, 359), -2);
    EXPECT_DOUBLE_EQ(wrapped(genes[1], 361), 1);
    EXPECT_DOUBLE_EQ(wrapped(genes[1], -1), 359);
    EXPECT_LT(wrapped(genes[1], -1e-18), 360);

    // Parents on both sides of north must have children near north, not near
    // south.
    Population parents = first_generation();
    RandomStream stream(1, Purpose::selection);
    for (Individual& i : parents)
        i.candidate.genome[1] = wrapped(genes[1], stream.uniform(-5, 5));
    SearchSettings settings = small();
    settings.ga.mutations_per_child = 0;
    for (const Candidate& c : propose_generation(settings, 7, 1, parents))
        EXPECT_GT(std::cos(c.genome[1] * std::acos(-1.) / 180), 0.5);
}

TEST(GeneticAlgorithm, MutationMovesGenesAtTheGivenRate) {
    SearchSettings settings = small();
    settings.population = 2003;
    settings.ga.crossover_probability = 0;
    const auto first = evaluate(propose_generation(settings, 7, 0, {}));
    int changed = 0;
    const auto children = propose_generation(settings, 7, 1, first);
    for (std::size_t i = 3; i < children.size(); ++i) {
        const auto& parent =
            first[static_cast<std::size_t>(children[i].parents[0])];
        for (std::size_t g = 0; g < 2; ++g)
            changed +=
                children[i].genome[g] != parent.candidate.genome[g] ? 1 : 0;
    }
    // One of the two free genes of each child mutates on average:
    // binomial(4000, 1/2).
    EXPECT_NEAR(changed, 2000, 5 * std::sqrt(1000.));
}

}  // namespace
}  // namespace ideotype
