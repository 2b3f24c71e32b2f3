// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "contracts.hpp"
#include "individual.hpp"
#include "search/breeder.hpp"
#include "search/cma_es/dd_cma.hpp"
#include "search/optimizer.hpp"
#include "search/order.hpp"
#include "search/outcome.hpp"
#include "search/sensitivity_design.hpp"
#include "search/sobol_sequence.hpp"
#include "search/stop_rules.hpp"
#include "search/summary.hpp"
#include "search/unbounded_genes.hpp"

namespace ideotype {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

//! A space of two free genes with a baseline.
SearchSpace two_genes() {
    return {{{"leaf01_length", "m", 0, 1, false, true, "length", 1},
             {"leaf01_azimuth", "deg", 0, 360, true, true, "azimuth", 1}},
            {0.5, 90}};
}

SearchSpace without_baseline() {
    SearchSpace space = two_genes();
    space.baseline.clear();
    return space;
}

SearchSettings settings_of(OptimizerKind optimizer, int population = 8) {
    SearchSettings settings;
    settings.optimizer = optimizer;
    settings.population = population;
    return settings;
}

//! Returns an optimizer of a kind before its first row.
std::unique_ptr<GenerationalOptimizer> search_by(OptimizerKind optimizer,
                                                 int population = 8) {
    const SearchSettings settings = settings_of(optimizer, population);
    switch (optimizer) {
        case OptimizerKind::automatic:
            return make_auto_search(settings, two_genes(), 1);
        case OptimizerKind::cma_es:
            return make_cma_es(settings, two_genes(), 1);
        default:
            return make_genetic_algorithm(settings, two_genes(), 1);
    }
}

void breed(const Genome& mother, const Genome& father) {
    const Individual a = individual(mother, 1), b = individual(father, 1);
    int asked = 0;
    GaSettings settings;
    settings.mutations_per_child = 0;
    Breeder(settings, two_genes(), 1)
        .children([&](RandomStream&) { return Parent{asked++ ? b : a}; }, 1, 0);
}

DdCma distribution() {
    return {Eigen::VectorXd::Zero(2), Eigen::VectorXd::Ones(2), 4};
}

SensitivityDesign design(SensitivitySettings settings = {}) {
    return {settings, two_genes(), 1};
}

Population with_objectives(std::size_t count) {
    Individual each = individual({0.5, 90}, 1);
    each.objectives.resize(count);
    return {each, each};
}

const std::vector<Sense> two(2, Sense::maximise);

}  // namespace

TEST(Contracts, OfBreedingAreNoticed) {
    GaSettings certain;
    certain.crossover_probability = 1.5;
    expect_noticed({
        {"space_.baseline.size() == space_.genes.size()",
         [] { Breeder({}, without_baseline(), 1); }},
        {"settings.crossover_probability >= 0 && "
         "settings.crossover_probability <= 1",
         [=] { Breeder(certain, two_genes(), 1); }},
        {"mother.individual.candidate.genome.size() == space_.genes.size()",
         [] {
             breed({0.5}, {0.5, 90});
         }},
        {"father.individual.candidate.genome.size() == space_.genes.size()",
         [] {
             breed({0.5, 90}, {0.5});
         }},
        {"!gene.is_free || (genome[i] >= gene.lower && genome[i] <= "
         "gene.upper)",
         [] {
             breed({0.5, 361}, {0.5, 361});
         }},
        {"space.baseline.size() == space.genes.size()",
         [] { random_genome(without_baseline(), 1, 0, 0); }},
    });
}

TEST(Contracts, OfDdCmaAreNoticed) {
    using Eigen::MatrixXd;
    using Eigen::VectorXd;
    expect_noticed({
        {"mean_.size() > 0 && mean_.size() == scales_.size()",
         [] { DdCma(VectorXd::Zero(2), VectorXd::Ones(3), 4); }},
        {"(scales_.array() > 0).all()",
         [] { DdCma(VectorXd::Zero(2), VectorXd::Zero(2), 4); }},
        {"population >= 4",
         [] { DdCma(VectorXd::Zero(2), VectorXd::Ones(2), 3); }},
        {"normal.size() == mean_.size()",
         [] { distribution().sample(VectorXd::Zero(3)); }},
        {"ranked.rows() == mean_.size()",
         [] { distribution().update(MatrixXd::Zero(3, 4)); }},
        {"ranked.cols() == of_correlation_.weights.size()",
         [] { distribution().update(MatrixXd::Zero(2, 5)); }},
        {"ranked.allFinite()",
         [] { distribution().update(MatrixXd::Constant(2, 4, nan)); }},
    });
}

TEST(Contracts, OfOptimizersAreNoticed) {
    using enum OptimizerKind;
    expect_noticed({
        {"settings.population > 0", [] { search_by(ga, 0); }},
        {"settings.population > 0",
         [] { make_optimizer(settings_of(random, 0), two_genes(), 1); }},
        {"slot < next_size()", [] { search_by(ga)->candidate(8); }},
        {"slot < next_size()", [] { search_by(automatic)->candidate(24); }},
        {"plant < population_", [] { search_by(cma_es)->candidate(8); }},
        {"count > 0", [] { search_by(cma_es)->best(0); }},
        {"!evaluated.empty()", [] { search_by(ga)->tell({}); }},
        {"rows.size() == population_",
         [] { search_by(cma_es)->tell(with_objectives(1)); }},
        {"generation == generation_", [] { search_by(ga)->size(1); }},
        {"generation == generation_", [] { search_by(ga)->propose(1, 0); }},
    });
}

TEST(Contracts, OfOrderAreNoticed) {
    const Population one = with_objectives(1), none = with_objectives(0);
    expect_noticed({
        {"!a.objectives.empty() && !b.objectives.empty()",
         [=] { is_better(none[0], none[1], Sense::maximise); }},
        {"a.objectives.size() == senses.size()", [=] { fronts(one, two); }},
        {"!front.empty()", [=] { crowding(one, {}, 1); }},
        {"!senses.empty()", [=] { places(one, {}); }},
    });
}

TEST(Contracts, OfOutcomesAreNoticed) {
    OutcomeSchema schema;
    schema.objectives = {{"light", "1"}};
    schema.measured.quantities = {{"lai", "m2 m-2", "leaf area"}};
    Outcome outcome = unknown_outcome(schema);
    Outcome lacking = outcome;
    lacking.quantities.clear();
    Outcome odd = outcome;
    odd.objectives.resize(2);
    odd.randomisations.resize(3);
    expect_noticed({
        {"outcome.quantities.size() == schema.measured.size()",
         [=] { find(schema, lacking, "lai"); }},
        {"objective < outcome.objectives.size()",
         [=] { randomisations_of(outcome, 1); }},
        {"outcome.randomisations.size() % outcome.objectives.size() == 0",
         [=] { randomisations_of(odd, 1); }},
    });
}

TEST(Contracts, OfGenesAreNoticed) {
    const GeneSpace genes = two_genes().genes;
    expect_noticed({
        {"gene.is_circular && gene.lower < gene.upper",
         [=] { wrapped(genes[0], 2); }},
        {"std::isfinite(value)", [=] { wrapped(genes[1], nan); }},
        {"genome.size() == genes_.size()",
         [=] { UnboundedGenes(genes).of({0.5}); }},
        {"share >= 0 && share <= 1",
         [=] {
             UnboundedGenes(genes).of({nan, 90});
         }},
        {"coordinates.size() == free_.size()",
         [=] {
             UnboundedGenes(genes).genome({0}, {0.5, 90});
         }},
        {"original.size() == genes_.size()",
         [=] {
             UnboundedGenes(genes).genome({0, 0}, {0.5});
         }},
        {"dimension < scramble_seeds_.size()",
         [] { SobolSequence(1, 2).at(0, 2); }},
    });
}

TEST(Contracts, OfSensitivityDesignsAreNoticed) {
    SensitivitySettings odd;
    odd.levels = 3;
    SensitivitySettings few;
    few.samples = 16;
    expect_noticed({
        {"settings.levels >= 2 && settings.levels % 2 == 0",
         [=] { design(odd); }},
        {"sample < samples() && place < rows_per_sample()",
         [] { design().row(0, 4); }},
        {"sample < samples() && place < rows_per_sample()",
         [=] { design(few).propose(1, 0); }},
        {"space_.baseline.size() == space_.genes.size()",
         [] { SensitivityDesign({}, without_baseline(), 1).row(0, 0); }},
        {"before < samples()", [=] { design(few).size(1); }},
    });
}

TEST(Contracts, OfSummariesAreNoticed) {
    StopRules short_line;
    short_line.no_gain = 2;
    const std::vector<std::vector<double>> points{{1, 1}}, short_points{{1}};
    const Progress some{std::vector<GenerationSummary>(2)}, past{{}, -1};
    expect_noticed({
        {"generations > 2",
         [=] { finished(short_line, some, Sense::maximise); }},
        {"!(progress.wall_time < 0)",
         [=] { finished({}, past, Sense::maximise); }},
        {"reference.size() == senses.size()",
         [=] { hypervolume(points, {0}, two); }},
        {"point.size() == senses.size()",
         [=] {
             hypervolume(short_points, {0, 0}, two);
         }},
        {"!senses_.empty()", [] { Summarizer({}, {}, {}); }},
        {"reference_.empty() || reference_.size() == senses_.size()",
         [] { Summarizer({}, two, {1}); }},
    });
}

}  // namespace ideotype
