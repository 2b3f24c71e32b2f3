#include <array>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "ideotype/core/random.hpp"
#include "ideotype/search/breed.hpp"

namespace ideotype {
namespace {

const GeneSpace genes{{"length", "m", 0.4, 1.1, false, true},
                      {"azimuth", "deg", 0, 360, true, true},
                      {"width", "m", 0.05, 0.14, false, false}};
const Genome baseline{0.7, 90, 0.08};

GaSettings small_optimizer() {
    GaSettings optimizer;
    optimizer.population = 41;
    optimizer.elites = 3;
    optimizer.mutations_per_child = 1;
    return optimizer;
}

//! A generation whose fitness is the first gene.
Population evaluated(const std::vector<Candidate>& candidates) {
    Population population;
    for (const Candidate& c : candidates)
        population.push_back({c, Status::done, c.genome[0], 0.01});
    return population;
}

Population first_generation() {
    return evaluated(breed(small_optimizer(), genes, baseline, 7, 0, {}));
}

TEST(Breed, FirstGenerationIsTheBaselineAndRandomGenomes) {
    const Population first = first_generation();
    ASSERT_EQ(first.size(), 41u);
    EXPECT_EQ(first[0].candidate.genome, baseline);
    EXPECT_EQ(first[0].candidate.origin, Origin::baseline);
    std::set<double> lengths;
    for (const Individual& i : first) lengths.insert(i.candidate.genome[0]);
    EXPECT_EQ(lengths.size(), 41u);
    EXPECT_EQ(first[40].candidate.origin, Origin::random);
}

TEST(Breed, IsAPureFunctionOfItsArguments) {
    const Population parents = first_generation();
    const auto genomes = [&](std::uint64_t seed, std::uint32_t generation) {
        std::vector<Genome> all;
        for (const Candidate& c : breed(small_optimizer(), genes, baseline,
                                        seed, generation, parents))
            all.push_back(c.genome);
        return all;
    };
    EXPECT_EQ(genomes(7, 1), genomes(7, 1));
    EXPECT_NE(genomes(7, 1), genomes(8, 1));
    EXPECT_NE(genomes(7, 1), genomes(7, 2));
}

// Contract C3: another order of random numbers or of operations would make
// other children. Write new values only with a change that is meant to do that.
TEST(Breed, ChildrenOfASeedStayTheSame) {
    struct Child {
        std::array<std::int32_t, 2> parents;
        double length, azimuth;
    };
    const Child expected[]{{{35, 38}, 1.0267507584486153, 45.690095471594503},
                           {{38, 35}, 1.0199458617718744, 345.97144121514339},
                           {{7, 33}, 1.0314798684108246, 311.28735183111371},
                           {{33, 7}, 0.79891001066969458, 283.23988899599806},
                           {{17, 5}, 0.74890761955041629, 238.39932495100061},
                           {{5, 17}, 0.48206519316227509, 337.73144000148335},
                           {{24, 0}, 0.90261582956160313, 107.94439402888037},
                           {{0, 24}, 0.68144722408303704, 88.718537666155399},
                           {{19, 11}, 1.0258171986935358, 180.32462170641767}};
    const auto children =
        breed(small_optimizer(), genes, baseline, 7, 1, first_generation());
    std::size_t slot = 3;
    for (const Child& child : expected) {
        EXPECT_EQ(children[slot].parents, child.parents) << slot;
        EXPECT_EQ(children[slot].genome,
                  (Genome{child.length, child.azimuth, baseline[2]}))
            << slot;
        ++slot;
    }
}

TEST(Breed, ChildrenStayInsideBounds) {
    Population parents = first_generation();
    for (std::uint32_t g = 1; g < 60; ++g) {
        parents =
            evaluated(breed(small_optimizer(), genes, baseline, 7, g, parents));
        for (const Individual& i : parents) {
            EXPECT_GE(i.candidate.genome[0], 0.4);
            EXPECT_LE(i.candidate.genome[0], 1.1);
            EXPECT_GE(i.candidate.genome[1], 0);
            EXPECT_LT(i.candidate.genome[1], 360);
        }
    }
}

TEST(Breed, GenesThatAreNotFreeKeepTheBaseline) {
    Population parents = first_generation();
    for (std::uint32_t g = 1; g < 10; ++g) {
        parents =
            evaluated(breed(small_optimizer(), genes, baseline, 7, g, parents));
        for (const Individual& i : parents)
            EXPECT_EQ(i.candidate.genome[2], baseline[2]);
    }
}

TEST(Breed, ElitesAreTheBestDistinctParents) {
    Population parents = first_generation();
    parents[5].candidate.genome[0] = parents[9].candidate.genome[0] = 1.09;
    parents[5].candidate.genome[1] = parents[9].candidate.genome[1] = 11;
    parents[5].fitness = parents[9].fitness = 1.09;
    const auto children =
        breed(small_optimizer(), genes, baseline, 7, 1, parents);
    EXPECT_EQ(children[0].genome, parents[5].candidate.genome);
    EXPECT_EQ(children[0].parents[0], 5);
    EXPECT_NE(children[1].genome, children[0].genome);
    EXPECT_EQ(children[2].origin, Origin::elite);
    EXPECT_EQ(children[3].origin, Origin::child);
}

TEST(Breed, SelectionImprovesThePopulation) {
    Population parents = first_generation();
    for (std::uint32_t g = 1; g < 40; ++g)
        parents =
            evaluated(breed(small_optimizer(), genes, baseline, 7, g, parents));
    double mean = 0;
    for (const Individual& i : parents) mean += i.fitness / 41;
    EXPECT_GT(mean, 1.05);
}

TEST(Breed, AFailedParentIsNeverChosenOverAnother) {
    Population parents = first_generation();
    for (std::size_t i = 1; i < parents.size(); ++i)
        parents[i].status = Status::failed;
    GaSettings optimizer = small_optimizer();
    optimizer.tournament = 200;
    const auto children = breed(optimizer, genes, baseline, 7, 1, parents);
    EXPECT_EQ(children[0].genome, baseline);
    for (std::size_t i = 1; i < children.size(); ++i)
        EXPECT_EQ(children[i].parents[0], 0);
}

TEST(Breed, AzimuthCrossesTheNorthByTheShortWay) {
    EXPECT_DOUBLE_EQ(difference(genes[1], 359, 1), 2);
    EXPECT_DOUBLE_EQ(difference(genes[1], 1, 359), -2);
    EXPECT_DOUBLE_EQ(wrapped(genes[1], 361), 1);
    EXPECT_DOUBLE_EQ(wrapped(genes[1], -1), 359);
    EXPECT_LT(wrapped(genes[1], -1e-18), 360);

    // Parents on both sides of north have children near north, never south.
    Population parents = first_generation();
    RandomStream stream(1, Purpose::selection);
    for (Individual& i : parents)
        i.candidate.genome[1] = wrapped(genes[1], stream.uniform(-5, 5));
    GaSettings optimizer = small_optimizer();
    optimizer.mutations_per_child = 0;
    for (const Candidate& c : breed(optimizer, genes, baseline, 7, 1, parents))
        EXPECT_GT(std::cos(c.genome[1] * std::acos(-1.) / 180), 0.5);
}

TEST(Breed, MutationMovesGenesAtTheGivenRate) {
    GaSettings optimizer = small_optimizer();
    optimizer.population = 2003;
    optimizer.crossover_probability = 0;
    const auto first = evaluated(breed(optimizer, genes, baseline, 7, 0, {}));
    int changed = 0;
    const auto children = breed(optimizer, genes, baseline, 7, 1, first);
    for (std::size_t i = 3; i < children.size(); ++i) {
        const auto& parent =
            first[static_cast<std::size_t>(children[i].parents[0])];
        for (std::size_t g = 0; g < 2; ++g)
            changed +=
                children[i].genome[g] != parent.candidate.genome[g] ? 1 : 0;
    }
    // One of two free genes per child on average: binomial(4000, 1/2).
    EXPECT_NEAR(changed, 2000, 5 * std::sqrt(1000.));
}

}  // namespace
}  // namespace ideotype
