#include "ideotype/search/genetic_algorithm.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "ideotype/search/order.hpp"
#include "ideotype/search/pareto.hpp"
#include "ideotype/search/random_search.hpp"
#include "variation.hpp"

namespace ideotype {

GeneticAlgorithm::GeneticAlgorithm(const SearchSettings& settings,
                                   SearchSpace space, std::uint64_t seed)
    : settings_(settings), space_(std::move(space)), seed_(seed) {}

std::vector<Candidate> GeneticAlgorithm::ask() const {
    if (generation_ == 0) return first_generation();
    std::vector<Candidate> candidates = best(elites());
    const auto size = static_cast<std::size_t>(settings_.population);
    while (candidates.size() < size) {
        auto [first, second] =
            children(static_cast<std::uint32_t>(candidates.size()));
        candidates.push_back(std::move(first));
        candidates.push_back(std::move(second));
    }
    candidates.resize(size);
    return candidates;
}

void GeneticAlgorithm::tell(Population evaluated) {
    parents_ = std::move(evaluated);
    places_ = places(parents_, space_.senses);
    if (is_pareto()) mates_ = best_distinct(parents_, elites(), space_.senses);
    if (!is_pareto() || mates_.empty()) {
        mates_.resize(parents_.size());
        std::iota(mates_.begin(), mates_.end(), 0u);
    }
    ++generation_;
}

bool GeneticAlgorithm::is_pareto() const {
    return settings_.optimizer == OptimizerKind::nsga2;
}

std::size_t GeneticAlgorithm::elites() const {
    return static_cast<std::size_t>(is_pareto() ? settings_.population / 2
                                                : settings_.ga.elites);
}

std::vector<Candidate> GeneticAlgorithm::best(std::size_t count) const {
    return best_of(parents_, count, space_.senses);
}

std::vector<Candidate> GeneticAlgorithm::first_generation() const {
    std::vector<Candidate> candidates{{space_.baseline, Origin::baseline}};
    const auto size = static_cast<std::uint32_t>(settings_.population);
    for (std::uint32_t slot = 1; slot < size; ++slot)
        candidates.push_back(
            {random_genome(space_, seed_, generation_, slot), Origin::random});
    return candidates;
}

//! The children of one couple, for this slot and the next.
std::pair<Candidate, Candidate> GeneticAlgorithm::children(
    std::uint32_t slot) const {
    RandomStream selection(seed_, Purpose::selection, generation_, slot);
    const std::int32_t first_parent = tournament(selection);
    const std::int32_t second_parent = tournament(selection);
    const auto genome_of = [&](std::int32_t parent) {
        return parents_[static_cast<std::size_t>(parent)].candidate.genome;
    };
    Candidate first{
        genome_of(first_parent), Origin::child, {first_parent, second_parent}};
    Candidate second{
        genome_of(second_parent), Origin::child, {second_parent, first_parent}};
    RandomStream crossover(seed_, Purpose::crossover, generation_, slot);
    if (crossover.uniform() < settings_.ga.crossover_probability)
        for (std::size_t i = 0; i < space_.genes.size(); ++i) {
            const bool is_crossed = crossover.uniform() < 0.5;
            const double u = crossover.uniform();
            const bool is_swapped = crossover.uniform() < 0.5;
            if (!space_.genes[i].is_free || !is_crossed) continue;
            std::tie(first.genome[i], second.genome[i]) =
                cross(space_.genes[i], first.genome[i], second.genome[i], u,
                      settings_.ga.crossover_index);
            if (is_swapped) std::swap(first.genome[i], second.genome[i]);
        }
    mutate_genome(first.genome, slot);
    mutate_genome(second.genome, slot + 1);
    return {std::move(first), std::move(second)};
}

//! The slot of the best of some parents chosen at random.
std::int32_t GeneticAlgorithm::tournament(RandomStream& stream) const {
    const auto size = static_cast<std::uint32_t>(mates_.size());
    std::uint32_t winner = mates_[stream.below(size)];
    for (int i = 1; i < settings_.ga.tournament; ++i) {
        const std::uint32_t rival = mates_[stream.below(size)];
        if (places_[rival] < places_[winner]) winner = rival;
    }
    return static_cast<std::int32_t>(winner);
}

void GeneticAlgorithm::mutate_genome(Genome& genome, std::uint32_t slot) const {
    const auto free_genes =
        std::count_if(space_.genes.begin(), space_.genes.end(),
                      [](const Gene& gene) { return gene.is_free; });
    const double probability =
        settings_.ga.mutations_per_child / static_cast<double>(free_genes);
    RandomStream stream(seed_, Purpose::mutation, generation_, slot);
    for (std::size_t i = 0; i < space_.genes.size(); ++i) {
        const Gene& gene = space_.genes[i];
        const bool is_mutated = stream.uniform() < probability;
        const double u = stream.uniform();
        if (gene.is_free && is_mutated)
            genome[i] = mutate(gene, genome[i], u, settings_.ga.mutation_index);
    }
}

}  // namespace ideotype
