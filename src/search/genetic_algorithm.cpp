#include "ideotype/search/genetic_algorithm.hpp"

#include <numeric>

#include "ideotype/search/order.hpp"
#include "ideotype/search/pareto.hpp"

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
    candidates = best(elites());
    const Contest contest = [&](RandomStream& stream) {
        const std::size_t winner = this->contest(stream);
        const std::int64_t row =
            parents_row() + static_cast<std::int64_t>(winner);
        return Parent{parents_[winner], row};
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
    parents_ = std::move(evaluated);
    places_ = places(parents_, space_.senses);
    if (is_pareto()) mates_ = best_distinct(parents_, elites(), space_.senses);
    if (!is_pareto() || mates_.empty()) {
        mates_.resize(parents_.size());
        std::iota(mates_.begin(), mates_.end(), 0u);
    }
}

bool GeneticAlgorithm::is_pareto() const {
    return settings_.optimizer == OptimizerKind::nsga2;
}

std::size_t GeneticAlgorithm::elites() const {
    return static_cast<std::size_t>(is_pareto() ? settings_.population / 2
                                                : settings_.ga.elites);
}

std::vector<Candidate> GeneticAlgorithm::best(std::size_t count) const {
    return best_of(parents_, count, space_.senses, parents_row());
}

//! The slot of the best of some parents chosen at random.
std::size_t GeneticAlgorithm::contest(RandomStream& stream) const {
    const auto size = static_cast<std::uint32_t>(mates_.size());
    std::uint32_t winner = mates_[stream.below(size)];
    for (int i = 1; i < settings_.ga.tournament; ++i) {
        const std::uint32_t rival = mates_[stream.below(size)];
        if (places_[rival] < places_[winner]) winner = rival;
    }
    return winner;
}

}  // namespace ideotype
