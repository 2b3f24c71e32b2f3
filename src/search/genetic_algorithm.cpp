// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

#include "breeder.hpp"
#include "ideotype/core/contract.hpp"
#include "optimizer.hpp"
#include "order.hpp"

namespace ideotype {

namespace {

//! Returns the winner of a tournament among randomly drawn contestants.
template <class Beats>
std::uint32_t hold_tournament(RandomStream& stream, std::size_t size,
                              const GaSettings& settings, Beats beats) {
    IDEOTYPE_EXPECT(size > 0);
    const auto below = static_cast<std::uint32_t>(size);
    std::uint32_t winner = stream.below(below);
    for (int i = 1; i < settings.tournament; ++i) {
        const std::uint32_t rival = stream.below(below);
        if (beats(rival, winner)) winner = rival;
    }
    return winner;
}

//! A genetic algorithm with real-valued genes. Generation 0 consists of the
//! baseline in slot 0 and random genomes, uniform within their bounds, in all
//! other slots. Every later generation begins with the elites: the best
//! distinct genomes of the parents, which are re-evaluated. The other plants
//! are children of couples selected by tournament (see Breeder).
//!
//! With NSGA-II (Deb et al. 2002, doi:10.1109/4235.996017), a whole generation
//! are children. The next parents are the best distinct individuals among
//! children and parents, by front and crowding. Parents keep their outcomes,
//! although these may be lucky: re-evaluating them with the random numbers of
//! their children costs more than it gains (docs/results/searches.md).
class GeneticAlgorithm : public GenerationalOptimizer {
  public:
    GeneticAlgorithm(const SearchSettings& settings, SearchSpace space,
                     std::uint64_t seed)
        : settings_(settings),
          space_(std::move(space)),
          seed_(seed),
          breeder_(settings.ga, space_, seed) {
        IDEOTYPE_EXPECT(settings.population > 0);
    }

    std::size_t next_size() const override {
        return static_cast<std::size_t>(settings_.population);
    }

    Candidate candidate(std::uint32_t slot) override {
        IDEOTYPE_EXPECT(slot < next_size());
        if (generation() == 0) return make_founder(space_, seed_, 0, slot);
        if (slot < elites_.size()) return elites_[slot];
        const auto first = static_cast<std::uint32_t>(
            slot - (slot - elites_.size()) % 2);  // the first of two children
        if (!couple_ || couple_->first != first) {
            const Contest contest = [&](RandomStream& stream) {
                const std::size_t winner =
                    hold_tournament(stream, parents_.size(), settings_.ga,
                                    [&](std::size_t a, std::size_t b) {
                                        return places_[a] < places_[b];
                                    });
                return Parent{parents_[winner], rows_[winner]};
            };
            couple_ = {first,
                       breeder_.make_children(contest, generation(), first)};
        }
        return slot == first ? couple_->children.first
                             : couple_->children.second;
    }

    //! Returns the best distinct individuals among the next parents.
    std::vector<Candidate> best(std::size_t count) const override {
        std::vector<Candidate> best =
            select_best(parents_, count, space_.senses, 0);
        for (Candidate& candidate : best)
            candidate.parents[0] =
                rows_[static_cast<std::size_t>(candidate.parents[0])];
        return best;
    }

  private:
    void take(Population evaluated) override {
        std::vector<std::int64_t> rows(evaluated.size());
        std::iota(rows.begin(), rows.end(), parents_row());
        if (is_pareto()) {
            std::move(parents_.begin(), parents_.end(),
                      std::back_inserter(evaluated));
            rows.insert(rows.end(), rows_.begin(), rows_.end());
            keep_best(evaluated, rows);
        }
        parents_ = std::move(evaluated);
        rows_ = std::move(rows);
        IDEOTYPE_ENSURE(parents_.size() == rows_.size());
        places_ = places(parents_, space_.senses);
        couple_.reset();
        elites_.clear();
        if (!is_pareto())
            elites_ = best(std::min(
                static_cast<std::size_t>(settings_.ga.elites), next_size()));
    }

    //! A pair of children; the first is for slot `first`.
    struct Couple {
        std::uint32_t first = 0;
        std::pair<Candidate, Candidate> children;
    };

    bool is_pareto() const {
        return settings_.optimizer == OptimizerKind::nsga2;
    }

    //! Keeps the best distinct individuals of a population, unless all failed.
    void keep_best(Population& population,
                   std::vector<std::int64_t>& rows) const {
        Population selected;
        std::vector<std::int64_t> selected_rows;
        for (const std::uint32_t i : best_distinct(
                 population, static_cast<std::size_t>(settings_.population),
                 space_.senses)) {
            selected.push_back(population[i]);
            selected_rows.push_back(rows[i]);
        }
        if (selected.empty()) return;
        population = std::move(selected);
        rows = std::move(selected_rows);
    }

    SearchSettings settings_;
    SearchSpace space_;
    std::uint64_t seed_;
    Breeder breeder_;
    Population parents_;               //!< individuals that may have children
    std::vector<std::int64_t> rows_;   //!< rows of the parents
    std::vector<std::size_t> places_;  //!< ranks of the parents, see places()
    std::vector<Candidate> elites_;    //!< parents that are re-evaluated
    std::optional<Couple> couple_;     //!< the last children made
};

}  // namespace

std::unique_ptr<GenerationalOptimizer> make_genetic_algorithm(
    const SearchSettings& settings, SearchSpace space, std::uint64_t seed) {
    return std::make_unique<GeneticAlgorithm>(settings, std::move(space), seed);
}

}  // namespace ideotype
