// SPDX-License-Identifier: Apache-2.0
#include "optimizer.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "ideotype/core/random.hpp"
#include "order.hpp"
#include "sensitivity_design.hpp"
#include "sobol_sequence.hpp"

namespace ideotype {

namespace {

//! Genomes that fill the space within their bounds evenly, independent or as
//! points of a SobolSequence. Nothing is learnt from them: it is what any other
//! search has to beat.
class RandomSearch : public Optimizer {
  public:
    RandomSearch(const SearchSettings& settings, SearchSpace space,
                 std::uint64_t seed)
        : population_(static_cast<std::size_t>(settings.population)),
          space_(std::move(space)),
          seed_(seed) {
        if (settings.optimizer == OptimizerKind::sobol)
            sequence_.emplace(seed, count_free(space_.genes));
    }

    std::size_t size(std::uint32_t) const override { return population_; }

    //! Tells that two generations may be under way, so that nobody waits for
    //! the last plants of one.
    std::uint64_t needs(std::uint32_t generation,
                        std::uint32_t) const override {
        return (std::max(generation, 1u) - 1) * population_;
    }

    Candidate propose(std::uint32_t generation, std::uint32_t slot) override {
        if (!sequence_)
            return {random_genome(space_, seed_, generation, slot),
                    Origin::random};
        const auto point =
            static_cast<std::uint32_t>(generation * population_ + slot);
        Genome genome = space_.baseline;
        std::size_t dimension = 0;
        for (std::size_t i = 0; i < genome.size(); ++i) {
            const Gene& gene = space_.genes[i];
            if (!gene.is_free) continue;
            const double range = gene.upper - gene.lower;
            genome[i] = gene.lower + range * sequence_->at(point, dimension++);
        }
        return {std::move(genome), Origin::random};
    }

    void learn(Individual row) override {
        constexpr std::size_t most = 1000;
        best_.push_back(std::move(row));
        if (best_.size() < 2 * most) return;
        Population best;
        for (const std::uint32_t i : best_distinct(best_, most, space_.senses))
            best.push_back(std::move(best_[i]));
        best_ = std::move(best);
    }

    //! Returns the best distinct of all generations, without parents.
    std::vector<Candidate> best(std::size_t count) const override {
        std::vector<Candidate> best = best_of(best_, count, space_.senses, 0);
        for (Candidate& each : best) each.parents = {no_parent, no_parent};
        return best;
    }

  private:
    std::size_t population_;
    SearchSpace space_;
    std::uint64_t seed_;
    std::optional<SobolSequence> sequence_;  //!< of free genes
    Population best_;  //!< of all, as many as may be asked for
};

}  // namespace

Genome random_genome(const SearchSpace& space, std::uint64_t seed,
                     std::uint32_t generation, std::uint32_t slot) {
    RandomStream stream(seed, Purpose::initial_population, generation, slot);
    Genome genome = space.baseline;
    for (std::size_t i = 0; i < genome.size(); ++i) {
        const Gene& gene = space.genes[i];
        if (gene.is_free) genome[i] = stream.uniform(gene.lower, gene.upper);
    }
    return genome;
}

void GenerationalOptimizer::tell(Population evaluated) {
    parents_row_ = row_;
    row_ += static_cast<std::int64_t>(evaluated.size());
    asked_.clear();
    learnt_.clear();
    take(std::move(evaluated));
    ++generation_;
}

const std::vector<Candidate>& GenerationalOptimizer::asked() const {
    if (asked_.empty()) asked_ = ask();
    return asked_;
}

std::size_t GenerationalOptimizer::size(std::uint32_t) const {
    return asked().size();
}

std::uint64_t GenerationalOptimizer::needs(std::uint32_t generation,
                                           std::uint32_t) const {
    return generation == generation_
               ? static_cast<std::uint64_t>(row_)
               : std::numeric_limits<std::uint64_t>::max();
}

Candidate GenerationalOptimizer::propose(std::uint32_t, std::uint32_t slot) {
    return asked()[slot];
}

void GenerationalOptimizer::learn(Individual row) {
    learnt_.push_back(std::move(row));
    if (learnt_.size() == asked().size()) tell(std::exchange(learnt_, {}));
}

std::unique_ptr<Optimizer> make_optimizer(const SearchSettings& settings,
                                          const SearchSpace& space,
                                          std::uint64_t seed) {
    if (settings.design)
        return std::make_unique<SensitivityDesign>(*settings.design, space,
                                                   seed);
    switch (settings.optimizer) {
        case OptimizerKind::ga:
            if (settings.window > 0)
                return make_steady_state(settings, space, seed);
            break;
        case OptimizerKind::nsga2:
            break;
        case OptimizerKind::cma_es:
            return make_cma_es(settings, space, seed);
        case OptimizerKind::random:
        case OptimizerKind::sobol:
            return std::make_unique<RandomSearch>(settings, space, seed);
    }
    return make_genetic_algorithm(settings, space, seed);
}

}  // namespace ideotype
