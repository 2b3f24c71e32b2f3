// SPDX-License-Identifier: Apache-2.0
#include "genetic_algorithm.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "order.hpp"
#include "pareto.hpp"

namespace ideotype {

GeneticAlgorithm::GeneticAlgorithm(const SearchSettings& settings,
                                   SearchSpace space, std::uint64_t seed)
    : settings_(settings),
      space_(std::move(space)),
      breeder_(settings.ga, space_, seed) {}

std::vector<Candidate> GeneticAlgorithm::ask() const {
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
        const std::size_t winner = this->contest(stream);
        return Parent{parents_[winner], rows_[winner]};
    };
    while (candidates.size() < size) {
        auto [first, second] = breeder_.children(contest, generation(), slot());
        candidates.push_back(std::move(first));
        candidates.push_back(std::move(second));
    }
    candidates.resize(size);
    return candidates;
}

void GeneticAlgorithm::take(Population evaluated) {
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

//! Keeps the best distinct of a population, if any did not fail.
void GeneticAlgorithm::select(Population& all,
                              std::vector<std::int64_t>& rows) const {
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

bool GeneticAlgorithm::is_pareto() const {
    return settings_.optimizer == OptimizerKind::nsga2;
}

std::vector<Candidate> GeneticAlgorithm::best(std::size_t count) const {
    std::vector<Candidate> best = best_of(parents_, count, space_.senses, 0);
    for (Candidate& each : best)
        each.parents[0] = rows_[static_cast<std::size_t>(each.parents[0])];
    return best;
}

//! The slot of the best of some parents chosen at random.
std::size_t GeneticAlgorithm::contest(RandomStream& stream) const {
    const auto size = static_cast<std::uint32_t>(parents_.size());
    std::uint32_t winner = stream.below(size);
    for (int i = 1; i < settings_.ga.tournament; ++i) {
        const std::uint32_t rival = stream.below(size);
        if (places_[rival] < places_[winner]) winner = rival;
    }
    return winner;
}

}  // namespace ideotype
