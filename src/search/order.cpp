#include "ideotype/search/order.hpp"

#include <algorithm>
#include <numeric>
#include <set>

namespace ideotype {

bool is_better(double a, double b, Sense sense) {
    return sense == Sense::maximise ? a > b : a < b;
}

bool is_better(const Individual& a, const Individual& b, Sense sense) {
    if (a.status == Status::failed || b.status == Status::failed)
        return a.status != Status::failed && b.status == Status::failed;
    if (a.violation > 0 || b.violation > 0) return a.violation < b.violation;
    return is_better(a.objectives.front().mean, b.objectives.front().mean,
                     sense);
}

std::vector<std::uint32_t> best_distinct(const Population& population,
                                         std::size_t count, Sense sense) {
    std::vector<std::uint32_t> order(population.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) {
                         return is_better(population[a], population[b], sense);
                     });
    std::vector<std::uint32_t> best;
    std::set<Genome> seen;
    for (const std::uint32_t slot : order) {
        if (best.size() == count) break;
        const Individual& individual = population[slot];
        if (individual.status == Status::failed) break;
        if (seen.insert(individual.candidate.genome).second)
            best.push_back(slot);
    }
    return best;
}

std::vector<Candidate> best_of(const Population& population, std::size_t count,
                               Sense sense) {
    std::vector<Candidate> best;
    for (const std::uint32_t slot : best_distinct(population, count, sense))
        best.push_back({population[slot].candidate.genome,
                        Origin::elite,
                        {static_cast<std::int32_t>(slot), no_parent}});
    return best;
}

}  // namespace ideotype
