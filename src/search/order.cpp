// SPDX-License-Identifier: Apache-2.0
#include "order.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/mapped.hpp"

namespace ideotype {

bool is_better(double a, double b, Sense sense) {
    return sense == Sense::maximise ? a > b : a < b;
}

bool is_better(const Individual& a, const Individual& b, Sense sense) {
    if (a.status == Status::failed || b.status == Status::failed)
        return a.status != Status::failed && b.status == Status::failed;
    if (a.violation > 0 || b.violation > 0) return a.violation < b.violation;
    IDEOTYPE_EXPECT(!a.objectives.empty() && !b.objectives.empty());
    return is_better(a.objectives.front().mean, b.objectives.front().mean,
                     sense);
}

namespace {

bool dominates(const Individual& a, const Individual& b,
               const std::vector<Sense>& senses) {
    const bool is_decided = a.status == Status::failed ||
                            b.status == Status::failed || a.violation > 0 ||
                            b.violation > 0;
    if (is_decided) return is_better(a, b, senses.front());
    IDEOTYPE_EXPECT(a.objectives.size() == senses.size());
    IDEOTYPE_EXPECT(b.objectives.size() == senses.size());
    bool is_better_in_one = false;
    for (std::size_t k = 0; k < senses.size(); ++k) {
        const double x = a.objectives[k].mean, y = b.objectives[k].mean;
        if (is_better(y, x, senses[k])) return false;
        is_better_in_one |= is_better(x, y, senses[k]);
    }
    return is_better_in_one;
}

//! Returns the rank of each key; equal keys share a rank.
template <class Less>
std::vector<std::size_t> assign_places(std::size_t size, Less less) {
    std::vector<std::size_t> order(size), place(size);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), less);
    for (std::size_t i = 1; i < size; ++i)
        place[order[i]] =
            less(order[i - 1], order[i]) ? i : place[order[i - 1]];
    return place;
}

}  // namespace

std::vector<std::size_t> fronts(const Population& population,
                                const std::vector<Sense>& senses) {
    const std::size_t size = population.size();
    // Count the dominators of each individual, then remove front after front.
    std::vector<std::size_t> front(size), dominators(size);
    std::vector<std::vector<std::size_t>> dominated(size);
    for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j < size; ++j)
            if (i != j && dominates(population[i], population[j], senses)) {
                dominated[i].push_back(j);
                ++dominators[j];
            }
    std::vector<std::size_t> current;
    for (std::size_t i = 0; i < size; ++i)
        if (dominators[i] == 0) current.push_back(i);
    for (std::size_t level = 0; !current.empty(); ++level) {
        std::vector<std::size_t> next;
        for (const std::size_t i : current) {
            front[i] = level;
            for (const std::size_t j : dominated[i])
                if (--dominators[j] == 0) next.push_back(j);
        }
        current = std::move(next);
    }
    return front;
}

std::vector<double> crowding(const Population& population,
                             const std::vector<std::size_t>& front,
                             std::size_t objectives) {
    IDEOTYPE_EXPECT(!front.empty());
    constexpr double endless = std::numeric_limits<double>::infinity();
    std::vector<double> distance(front.size());
    std::vector<std::size_t> order(front.size());
    for (std::size_t k = 0; k < objectives; ++k) {
        const auto value = [&](std::size_t i) {
            return population[front[i]].objectives[k].mean;
        };
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_sort(
            order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return value(a) < value(b); });
        const double range = value(order.back()) - value(order.front());
        distance[order.front()] = distance[order.back()] = endless;
        if (!(range > 0)) continue;
        for (std::size_t i = 1; i + 1 < order.size(); ++i)
            distance[order[i]] += (value(order[i + 1]) - value(order[i - 1])) /
                                  range / static_cast<double>(objectives);
    }
    return distance;
}

std::vector<std::size_t> places(const Population& population,
                                const std::vector<Sense>& senses) {
    IDEOTYPE_EXPECT(!senses.empty());
    if (senses.size() == 1)
        return assign_places(
            population.size(), [&](std::size_t a, std::size_t b) {
                return is_better(population[a], population[b], senses.front());
            });
    const std::vector<std::size_t> front = fronts(population, senses);
    std::vector<double> distance(population.size());
    std::vector<std::vector<std::size_t>> members(population.size());
    for (std::size_t i = 0; i < population.size(); ++i)
        if (population[i].status != Status::failed)
            members[front[i]].push_back(i);
    for (const std::vector<std::size_t>& slots : members) {
        if (slots.empty()) continue;
        const auto distances = crowding(population, slots, senses.size());
        for (std::size_t i = 0; i < slots.size(); ++i)
            distance[slots[i]] = distances[i];
    }
    return assign_places(population.size(), [&](std::size_t a, std::size_t b) {
        return front[a] != front[b] ? front[a] < front[b]
                                    : distance[a] > distance[b];
    });
}

std::vector<std::uint32_t> ranking(const Population& population,
                                   const std::vector<Sense>& senses) {
    const std::vector<std::size_t> place = places(population, senses);
    std::vector<std::uint32_t> order(population.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(
        order.begin(), order.end(),
        [&](std::uint32_t a, std::uint32_t b) { return place[a] < place[b]; });
    return order;
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

std::vector<Candidate> select_best(const Population& population,
                                   std::size_t count,
                                   const std::vector<Sense>& senses,
                                   std::int64_t first_row) {
    return mapped(best_distinct(population, count, senses),
                  [&](std::uint32_t slot) {
                      return Candidate{population[slot].candidate.genome,
                                       Origin::elite,
                                       {first_row + slot, no_parent}};
                  });
}

}  // namespace ideotype
