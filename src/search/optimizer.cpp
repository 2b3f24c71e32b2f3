// SPDX-License-Identifier: Apache-2.0
#include "optimizer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/random.hpp"
#include "order.hpp"
#include "sensitivity_design.hpp"
#include "sobol_sequence.hpp"

namespace ideotype {

namespace {

//! Proposes genomes that cover the space within their bounds: independent
//! random numbers, or points of a SobolSequence. It does not learn, and is the
//! reference for all other searches.
class RandomSearch : public Optimizer {
  public:
    RandomSearch(const SearchSettings& settings, SearchSpace space,
                 std::uint64_t seed)
        : population_(static_cast<std::size_t>(settings.population)),
          space_(std::move(space)),
          seed_(seed) {
        IDEOTYPE_EXPECT(settings.population > 0);
        if (settings.optimizer == OptimizerKind::sobol)
            sequence_.emplace(seed, count_free(space_.genes));
    }

    std::size_t size(std::uint32_t) const override { return population_; }

    //! Allows two generations in flight, so that no worker waits for the last
    //! plants of a generation.
    std::uint64_t needs(std::uint32_t generation) const override {
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
            genome[i] = value_at(gene, sequence_->at(point, dimension++));
        }
        return {std::move(genome), Origin::random};
    }

    void learn(Individual row) override {
        constexpr std::size_t capacity = 1000;
        best_.push_back(std::move(row));
        if (best_.size() < 2 * capacity) return;
        Population best;
        for (const std::uint32_t i :
             best_distinct(best_, capacity, space_.senses))
            best.push_back(std::move(best_[i]));
        best_ = std::move(best);
    }

    //! Returns the best distinct plants of all generations, without parents.
    std::vector<Candidate> best(std::size_t count) const override {
        std::vector<Candidate> best =
            select_best(best_, count, space_.senses, 0);
        for (Candidate& candidate : best)
            candidate.parents = {no_parent, no_parent};
        return best;
    }

  private:
    std::size_t population_;
    SearchSpace space_;
    std::uint64_t seed_;
    std::optional<SobolSequence> sequence_;  //!< points of free genes
    Population best_;  //!< best rows so far, at most twice the capacity
};

std::unique_ptr<GenerationalOptimizer> make_generational(
    const SearchSettings& settings, const SearchSpace& space,
    std::uint64_t seed) {
    switch (settings.optimizer) {
        case OptimizerKind::automatic:
            return make_auto_search(settings, space, seed);
        case OptimizerKind::cma_es:
            return make_cma_es(settings, space, seed);
        case OptimizerKind::atlas:
            return make_atlas(settings, space, seed);
        default:
            return make_genetic_algorithm(settings, space, seed);
    }
}

//! Runs independent searches in turn: generation g belongs to search g mod n.
//! Each search waits only for its own generations, while generations of other
//! searches keep workers busy.
class Streams : public Optimizer {
  public:
    Streams(const SearchSettings& settings, const SearchSpace& space,
            std::uint64_t seed)
        : senses_(space.senses) {
        for (int i = 0; i < settings.streams; ++i) {
            const auto number = static_cast<std::uint32_t>(i);
            const auto key =
                RandomStream(seed, Purpose::stream, number).bits64();
            streams_.push_back(
                {make_generational(settings, space, i == 0 ? seed : key)});
        }
    }

    std::size_t size(std::uint32_t generation) const override {
        return select_stream(generation).search->size(find_turn(generation));
    }

    std::uint64_t needs(std::uint32_t generation) const override {
        const auto turns = static_cast<std::uint32_t>(streams_.size());
        if (generation < turns) return 0;
        if (generation - turns < ends_.size()) return ends_[generation - turns];
        return std::numeric_limits<std::uint64_t>::max();
    }

    Candidate propose(std::uint32_t generation, std::uint32_t slot) override {
        const Stream& stream = select_stream(generation);
        return renumber_parents(
            stream, stream.search->propose(find_turn(generation), slot));
    }

    void learn(Individual row) override {
        const auto generation = static_cast<std::uint32_t>(ends_.size());
        Stream& stream = streams_[generation % streams_.size()];
        if (learnt_.empty())
            stream.first_rows.push_back(
                {stream.rows, static_cast<std::int64_t>(rows_)});
        const std::size_t size = stream.search->size(find_turn(generation));
        learnt_.push_back(row);
        stream.search->learn(std::move(row));
        ++rows_;
        ++stream.rows;
        if (learnt_.size() < size) return;
        stream.last = std::exchange(learnt_, {});
        ends_.push_back(rows_);
    }

    //! Returns the best candidates of all searches in turn. The first is from
    //! the search with the best row in its last generation.
    std::vector<Candidate> best(std::size_t count) const override {
        Population leaders;
        std::vector<const Stream*> led;
        for (const Stream& stream : streams_) {
            if (stream.last.empty()) continue;
            led.push_back(&stream);
            leaders.push_back(
                stream.last[ranking(stream.last, senses_).front()]);
        }
        // Take proposals in turn, beginning with the leading search.
        std::vector<std::vector<Candidate>> proposals;
        for (const std::uint32_t i : ranking(leaders, senses_)) {
            proposals.push_back(led[i]->search->best(count));
            for (Candidate& candidate : proposals.back())
                candidate = renumber_parents(*led[i], std::move(candidate));
        }
        std::vector<Candidate> best;
        for (std::size_t i = 0; i < count; ++i)
            for (std::vector<Candidate>& candidates : proposals)
                if (i < candidates.size() && best.size() < count)
                    best.push_back(std::move(candidates[i]));
        return best;
    }

  private:
    struct Stream {
        std::unique_ptr<GenerationalOptimizer> search;
        std::int64_t rows = 0;
        //! First row of each generation, as numbered by the search and by the
        //! case.
        std::vector<std::array<std::int64_t, 2>> first_rows{};
        Population last{};  //!< last generation

        std::int64_t find_row(std::int64_t row) const {
            const auto after = std::upper_bound(
                first_rows.begin(), first_rows.end(), row,
                [](std::int64_t r, const auto& first) { return r < first[0]; });
            IDEOTYPE_EXPECT(after != first_rows.begin());
            return row - (*std::prev(after))[0] + (*std::prev(after))[1];
        }
    };

    const Stream& select_stream(std::uint32_t generation) const {
        return streams_[generation % streams_.size()];
    }
    std::uint32_t find_turn(std::uint32_t generation) const {
        return generation / static_cast<std::uint32_t>(streams_.size());
    }

    //! Converts the parents of a candidate to row numbers of the case.
    static Candidate renumber_parents(const Stream& stream,
                                      Candidate candidate) {
        for (std::int64_t& parent : candidate.parents)
            if (parent != no_parent) parent = stream.find_row(parent);
        return candidate;
    }

    std::vector<Sense> senses_;
    std::vector<Stream> streams_;
    //! Rows up to the end of each generation.
    std::vector<std::uint64_t> ends_;
    std::uint64_t rows_ = 0;
    Population learnt_;  //!< learnt rows of the current generation
};

}  // namespace

Genome random_genome(const SearchSpace& space, std::uint64_t seed,
                     std::uint32_t generation, std::uint32_t slot) {
    IDEOTYPE_EXPECT(space.baseline.size() == space.genes.size());
    RandomStream stream(seed, Purpose::initial_population, generation, slot);
    Genome genome = space.baseline;
    for (std::size_t i = 0; i < genome.size(); ++i) {
        const Gene& gene = space.genes[i];
        if (gene.is_free) genome[i] = value_at(gene, stream.uniform());
    }
    return genome;
}

Candidate make_founder(const SearchSpace& space, std::uint64_t seed,
                       std::uint32_t generation, std::uint32_t slot) {
    if (generation == 0 && slot == 0) return {space.baseline, Origin::baseline};
    return {random_genome(space, seed, generation, slot), Origin::random};
}

int usual_population(OptimizerKind optimizer, std::size_t free_genes) {
    // Hansen's default population of CMA-ES.
    const int cma_es_size =
        4 + static_cast<int>(
                3 * std::log(std::max(1., static_cast<double>(free_genes))));
    if (optimizer == OptimizerKind::cma_es) return cma_es_size;
    // Two searches share the population, and both find more if it is somewhat
    // larger than twice the default.
    if (optimizer == OptimizerKind::automatic) return 5 * cma_es_size / 2;
    return 100;
}

void GenerationalOptimizer::tell(Population evaluated) {
    IDEOTYPE_EXPECT(!evaluated.empty());
    parents_row_ = row_;
    row_ += static_cast<std::int64_t>(evaluated.size());
    learnt_.clear();
    take(std::move(evaluated));
    ++generation_;
}

std::vector<Candidate> GenerationalOptimizer::ask() {
    std::vector<Candidate> candidates;
    while (candidates.size() < next_size())
        candidates.push_back(
            candidate(static_cast<std::uint32_t>(candidates.size())));
    return candidates;
}

std::size_t GenerationalOptimizer::size(std::uint32_t generation) const {
    IDEOTYPE_EXPECT(generation == generation_);
    return next_size();
}

std::uint64_t GenerationalOptimizer::needs(std::uint32_t generation) const {
    return generation == generation_
               ? static_cast<std::uint64_t>(row_)
               : std::numeric_limits<std::uint64_t>::max();
}

Candidate GenerationalOptimizer::propose(std::uint32_t generation,
                                         std::uint32_t slot) {
    IDEOTYPE_EXPECT(generation == generation_);
    return candidate(slot);
}

void GenerationalOptimizer::learn(Individual row) {
    learnt_.push_back(std::move(row));
    if (learnt_.size() == next_size()) tell(std::exchange(learnt_, {}));
}

std::unique_ptr<Optimizer> make_optimizer(const SearchSettings& settings,
                                          const SearchSpace& space,
                                          std::uint64_t seed) {
    if (settings.design)
        return std::make_unique<SensitivityDesign>(*settings.design, space,
                                                   seed);
    if (settings.optimizer == OptimizerKind::random ||
        settings.optimizer == OptimizerKind::sobol)
        return std::make_unique<RandomSearch>(settings, space, seed);
    if (settings.streams > 1)
        return std::make_unique<Streams>(settings, space, seed);
    return make_generational(settings, space, seed);
}

}  // namespace ideotype
