// SPDX-License-Identifier: Apache-2.0
#include "order.hpp"

#include <set>

#include "pareto.hpp"

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
                                         std::size_t count,
                                         const std::vector<Sense>& senses) {
    std::vector<std::uint32_t> best;
    std::set<Genome> seen;
    for (const std::uint32_t slot : ranking(population, senses)) {
        if (best.size() == count) break;
        const Individual& individual = population[slot];
        if (individual.status == Status::failed) break;
        if (seen.insert(individual.candidate.genome).second)
            best.push_back(slot);
    }
    return best;
}

std::vector<Candidate> best_of(const Population& population, std::size_t count,
                               const std::vector<Sense>& senses,
                               std::int64_t first_row) {
    std::vector<Candidate> best;
    for (const std::uint32_t slot : best_distinct(population, count, senses))
        best.push_back({population[slot].candidate.genome,
                        Origin::elite,
                        {first_row + slot, no_parent}});
    return best;
}

}  // namespace ideotype
