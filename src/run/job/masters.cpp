// SPDX-License-Identifier: Apache-2.0
#include "masters.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace ideotype {

namespace {

int part_of_case(int index, int cases, int parts) {
    return static_cast<int>(static_cast<long long>(index) * parts / cases);
}

constexpr int plants_of_worker = 4;

}  // namespace

int masters(std::optional<int> wanted, int ranks, int cases) {
    const int limit = std::max(1, std::min(ranks, cases));
    if (wanted) return std::clamp(*wanted, 1, limit);
    constexpr double ranks_of_one = 1000;
    return std::clamp(static_cast<int>(std::lround(ranks / ranks_of_one)), 1,
                      limit);
}

int part_of(int rank, int ranks, int cases, int parts) {
    const auto index =
        static_cast<int>(static_cast<long long>(rank) * cases / ranks);
    return part_of_case(index, cases, parts);
}

Share dealt(int cases, int part, int parts) {
    Share share;
    for (int i = 0; i < cases; ++i) {
        const int part_here = part_of_case(i, cases, parts);
        if (part_here < part) ++share.first;
        if (part_here == part) ++share.count;
    }
    return share;
}

int busy_workers(const SearchSettings& search, std::size_t cases) {
    const double plants = 1. * search.population * search.streams;
    return std::max(1, static_cast<int>(plants * static_cast<double>(cases) /
                                        plants_of_worker));
}

std::optional<std::string> advice_for(const Campaign& campaign,
                                      std::size_t cases, int workers) {
    const SearchSettings& search = campaign.search;
    const bool waits = !search.design &&
                       search.optimizer != OptimizerKind::random &&
                       search.optimizer != OptimizerKind::sobol;
    if (!waits) return std::nullopt;
    constexpr int fewest_generations = 40;
    constexpr long long fewest_plants = 8;
    const auto population = static_cast<long long>(search.population);
    long long rows = population * campaign.stop.generations;
    if (campaign.stop.evaluations > 0)
        rows = std::min(rows, campaign.stop.evaluations);
    const long long most_streams =
        std::max(1LL, rows / (fewest_generations * population));
    if (search.streams > most_streams)
        return fmt::format(
            "each of {} searches has only {} generations of {} plants, and "
            "learns little from fewer than {}; use search.streams = {}, or "
            "more generations",
            search.streams, rows / (search.streams * population), population,
            fewest_generations, most_streams);
    // If no more workers than this are idle, the loss is small.
    constexpr int few_workers = 8;
    if (workers > few_workers && rows < fewest_generations * population) {
        const long long fewer =
            std::max(fewest_plants, rows / fewest_generations);
        return fmt::format(
            "{} evaluations are only {:.3g} generations of {} plants, and a "
            "search learns little from fewer than {}; use more evaluations{}",
            rows, static_cast<double>(rows) / static_cast<double>(population),
            population, fewest_generations,
            fewer < population
                ? fmt::format(", or search.population = {} and fewer workers",
                              fewer)
                : "");
    }
    if (workers <= std::max(few_workers, busy_workers(search, cases)))
        return std::nullopt;
    SearchSettings enough = search;
    while (enough.streams < most_streams &&
           busy_workers(enough, cases) < workers)
        ++enough.streams;
    const int busy = busy_workers(enough, cases);
    if (enough.streams == search.streams)
        return fmt::format(
            "{} workers are more than {} can keep busy (about {}); use fewer "
            "workers, or more generations and streams",
            workers, cases == 1 ? "this case" : "these cases", busy);
    return fmt::format(
        "some of the {} workers are idle at the end of each generation; {} "
        "stay busy with search.streams = {}",
        workers, std::min(busy, workers), enough.streams);
}

}  // namespace ideotype
