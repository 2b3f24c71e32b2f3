// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <deque>
#include <iterator>
#include <numeric>
#include <utility>

#include "breeder.hpp"
#include "optimizer.hpp"
#include "order.hpp"

namespace ideotype {

namespace {

//! Returns the best of some contestants that are chosen at random from so many.
template <class Beats>
std::uint32_t tournament(RandomStream& stream, std::size_t size,
                         const GaSettings& settings, Beats beats) {
    const auto below = static_cast<std::uint32_t>(size);
    std::uint32_t winner = stream.below(below);
    for (int i = 1; i < settings.tournament; ++i) {
        const std::uint32_t rival = stream.below(below);
        if (beats(rival, winner)) winner = rival;
    }
    return winner;
}

//! A genetic algorithm with real-valued genes.
//!
//! Generation 0 is the baseline in slot 0 and genomes uniform within their
//! bounds in all others. Every later generation begins with the elites, the
//! best distinct genomes of the parents, which are evaluated again; the rest
//! are children of couples chosen by tournament (see Breeder).
//!
//! As NSGA-II (Deb et al. 2002, doi:10.1109/4235.996017) all of a generation
//! are children. The best distinct, by front and crowding, of them and of their
//! parents are the next parents. These keep what they were evaluated to, which
//! may be luck: to evaluate them again under the random numbers of their
//! children costs more than it gains (campaigns/study/RESULTS.md).
class GeneticAlgorithm : public GenerationalOptimizer {
  public:
    GeneticAlgorithm(const SearchSettings& settings, SearchSpace space,
                     std::uint64_t seed)
        : settings_(settings),
          space_(std::move(space)),
          breeder_(settings.ga, space_, seed) {}

    std::vector<Candidate> ask() const override {
        std::vector<Candidate> candidates;
        const auto size = static_cast<std::size_t>(settings_.population);
        const auto slot = [&] {
            return static_cast<std::uint32_t>(candidates.size());
        };
        if (generation() == 0) {
            while (candidates.size() < size)
                candidates.push_back(breeder_.founder(0, slot()));
            return candidates;
        }
        if (!is_pareto())
            candidates = best(static_cast<std::size_t>(settings_.ga.elites));
        const Contest contest = [&](RandomStream& stream) {
            const std::size_t winner =
                tournament(stream, parents_.size(), settings_.ga,
                           [&](std::size_t a, std::size_t b) {
                               return places_[a] < places_[b];
                           });
            return Parent{parents_[winner], rows_[winner]};
        };
        while (candidates.size() < size) {
            auto [first, second] =
                breeder_.children(contest, generation(), slot());
            candidates.push_back(std::move(first));
            candidates.push_back(std::move(second));
        }
        candidates.resize(size);
        return candidates;
    }

    //! Returns the best distinct of the next parents.
    std::vector<Candidate> best(std::size_t count) const override {
        std::vector<Candidate> best =
            best_of(parents_, count, space_.senses, 0);
        for (Candidate& each : best)
            each.parents[0] = rows_[static_cast<std::size_t>(each.parents[0])];
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
            select(evaluated, rows);
        }
        parents_ = std::move(evaluated);
        rows_ = std::move(rows);
        places_ = places(parents_, space_.senses);
    }

    bool is_pareto() const {
        return settings_.optimizer == OptimizerKind::nsga2;
    }

    //! Keeps the best distinct of a population, if any did not fail.
    void select(Population& all, std::vector<std::int64_t>& rows) const {
        Population selected;
        std::vector<std::int64_t> rows_of_selected;
        for (const std::uint32_t i :
             best_distinct(all, static_cast<std::size_t>(settings_.population),
                           space_.senses)) {
            selected.push_back(all[i]);
            rows_of_selected.push_back(rows[i]);
        }
        if (selected.empty()) return;
        all = std::move(selected);
        rows = std::move(rows_of_selected);
    }

    SearchSettings settings_;
    SearchSpace space_;
    Breeder breeder_;
    Population parents_;               //!< of the next generation
    std::vector<std::int64_t> rows_;   //!< of parents
    std::vector<std::size_t> places_;  //!< of parents, see places()
};

//! The genetic algorithm without a barrier between generations. The candidate
//! of row k follows from rows 0 to k - window alone: its parents are chosen by
//! tournament from the last of these, as many as a generation has, so that as
//! many as the window can be evaluated at the same time while nobody waits.
//! Rows that have no such parents are founders. As in the genetic algorithm,
//! the first slots of each generation are the best distinct parents, evaluated
//! again.
class SteadyState : public Optimizer {
  public:
    SteadyState(const SearchSettings& settings, SearchSpace space,
                std::uint64_t seed)
        : settings_(settings),
          space_(std::move(space)),
          breeder_(settings.ga, space_, seed),
          population_(static_cast<std::uint64_t>(settings.population)),
          window_(static_cast<std::uint64_t>(settings.window)) {}

    std::size_t size(std::uint32_t) const override { return population_; }

    std::uint64_t needs(std::uint32_t generation,
                        std::uint32_t slot) const override {
        const std::uint64_t next = generation * population_ + slot + 1;
        return next > window_ ? next - window_ : 0;
    }

    Candidate propose(std::uint32_t generation, std::uint32_t slot) override {
        const std::uint64_t end = needs(generation, slot);
        if (end < population_) return breeder_.founder(generation, slot);
        const std::uint64_t first = end - population_;
        const auto parent = [&](std::uint64_t row) {
            return Parent{known_[row - first_known_],
                          static_cast<std::int64_t>(row)};
        };
        if (slot < static_cast<std::uint32_t>(settings_.ga.elites)) {
            const auto elites =
                best_of(known_from(first), slot + 1, space_.senses,
                        static_cast<std::int64_t>(first));
            if (slot < elites.size()) return elites[slot];
        }
        const Contest contest = [&](RandomStream& stream) {
            return parent(first +
                          tournament(stream, population_, settings_.ga,
                                     [&](std::uint64_t a, std::uint64_t b) {
                                         return is_better(
                                             parent(first + a).individual,
                                             parent(first + b).individual,
                                             space_.senses.front());
                                     }));
        };
        return breeder_.children(contest, generation, slot).first;
    }

    void learn(Individual row) override {
        known_.push_back(std::move(row));
        // Those that row k + 1 may still need when row k is known.
        if (known_.size() <= population_ + window_) return;
        known_.pop_front();
        ++first_known_;
    }

    //! Returns the best distinct of the last generation.
    std::vector<Candidate> best(std::size_t count) const override {
        const std::uint64_t first =
            first_known_ + known_.size() -
            std::min<std::uint64_t>(population_, known_.size());
        return best_of(known_from(first), count, space_.senses,
                       static_cast<std::int64_t>(first));
    }

  private:
    //! The rows of at most a generation.
    Population known_from(std::uint64_t first) const {
        const std::uint64_t place = first - first_known_;
        const auto begin = known_.begin() + static_cast<std::ptrdiff_t>(place);
        const auto count = std::min(population_, known_.size() - place);
        return {begin, begin + static_cast<std::ptrdiff_t>(count)};
    }

    SearchSettings settings_;
    SearchSpace space_;
    Breeder breeder_;
    std::uint64_t population_, window_;
    std::deque<Individual> known_;  //!< the last rows
    std::uint64_t first_known_ = 0;
};

}  // namespace

std::unique_ptr<GenerationalOptimizer> make_genetic_algorithm(
    const SearchSettings& settings, SearchSpace space, std::uint64_t seed) {
    return std::make_unique<GeneticAlgorithm>(settings, std::move(space), seed);
}

std::unique_ptr<Optimizer> make_steady_state(const SearchSettings& settings,
                                             SearchSpace space,
                                             std::uint64_t seed) {
    return std::make_unique<SteadyState>(settings, std::move(space), seed);
}

}  // namespace ideotype
