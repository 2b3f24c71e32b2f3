// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <deque>
#include <utility>

#include "breeder.hpp"
#include "optimizer.hpp"
#include "order.hpp"

namespace ideotype {

namespace {

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
        const auto below = static_cast<std::uint32_t>(population_);
        const Contest contest = [&](RandomStream& stream) {
            std::uint64_t winner = first + stream.below(below);
            for (int i = 1; i < settings_.ga.tournament; ++i) {
                const std::uint64_t rival = first + stream.below(below);
                if (is_better(parent(rival).individual,
                              parent(winner).individual, space_.senses.front()))
                    winner = rival;
            }
            return parent(winner);
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

std::unique_ptr<Optimizer> make_steady_state(const SearchSettings& settings,
                                             SearchSpace space,
                                             std::uint64_t seed) {
    return std::make_unique<SteadyState>(settings, std::move(space), seed);
}

}  // namespace ideotype
