// SPDX-License-Identifier: Apache-2.0
#include "steady_state.hpp"

#include <algorithm>
#include <utility>

#include "order.hpp"

namespace ideotype {

SteadyState::SteadyState(const SearchSettings& settings, SearchSpace space,
                         std::uint64_t seed)
    : settings_(settings),
      space_(std::move(space)),
      breeder_(settings.ga, space_, seed),
      population_(static_cast<std::uint64_t>(settings.population)),
      window_(static_cast<std::uint64_t>(settings.window)) {}

std::uint64_t SteadyState::row(std::uint32_t generation,
                               std::uint32_t slot) const {
    return generation * population_ + slot;
}

std::uint64_t SteadyState::needs(std::uint32_t generation,
                                 std::uint32_t slot) const {
    const std::uint64_t next = row(generation, slot) + 1;
    return next > window_ ? next - window_ : 0;
}

Candidate SteadyState::propose(std::uint32_t generation, std::uint32_t slot) {
    const std::uint64_t end = needs(generation, slot);
    if (end < population_) return breeder_.founder(generation, slot);
    const std::uint64_t first = end - population_;
    const auto parent = [&](std::uint64_t row) {
        return Parent{known_[row - first_known_],
                      static_cast<std::int64_t>(row)};
    };
    if (slot < static_cast<std::uint32_t>(settings_.ga.elites)) {
        const auto begin =
            known_.begin() + static_cast<std::ptrdiff_t>(first - first_known_);
        const Population parents(
            begin, begin + static_cast<std::ptrdiff_t>(population_));
        const auto elites = best_of(parents, slot + 1, space_.senses,
                                    static_cast<std::int64_t>(first));
        if (slot < elites.size()) return elites[slot];
    }
    const auto below = static_cast<std::uint32_t>(population_);
    const Contest contest = [&](RandomStream& stream) {
        std::uint64_t winner = first + stream.below(below);
        for (int i = 1; i < settings_.ga.tournament; ++i) {
            const std::uint64_t rival = first + stream.below(below);
            if (is_better(parent(rival).individual, parent(winner).individual,
                          space_.senses.front()))
                winner = rival;
        }
        return parent(winner);
    };
    return breeder_.children(contest, generation, slot).first;
}

void SteadyState::learn(Individual row) {
    known_.push_back(std::move(row));
    // Those that row k + 1 may still need when row k is known.
    if (known_.size() <= population_ + window_) return;
    known_.pop_front();
    ++first_known_;
}

std::vector<Candidate> SteadyState::best(std::size_t count) const {
    const std::uint64_t size =
        std::min<std::uint64_t>(population_, known_.size());
    const Population last(known_.end() - static_cast<std::ptrdiff_t>(size),
                          known_.end());
    return best_of(
        last, count, space_.senses,
        static_cast<std::int64_t>(first_known_ + known_.size() - size));
}

}  // namespace ideotype
