#include "ideotype/search/rank.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <set>

namespace ideotype {

bool is_better(const Individual& a, const Individual& b) {
    if (a.status == Status::failed || b.status == Status::failed)
        return a.status != Status::failed && b.status == Status::failed;
    return a.fitness > b.fitness;
}

std::vector<std::uint32_t> best_distinct(const Population& population,
                                         std::size_t count) {
    std::vector<std::uint32_t> order(population.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) {
                         return is_better(population[a], population[b]);
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

std::map<std::uint32_t, std::uint32_t> duplicates(
    const std::vector<Candidate>& candidates) {
    std::map<Genome, std::uint32_t> first;
    std::map<std::uint32_t, std::uint32_t> earlier;
    for (std::uint32_t slot = 0; slot < candidates.size(); ++slot) {
        const auto [it, is_new] =
            first.try_emplace(candidates[slot].genome, slot);
        if (!is_new) earlier.emplace(slot, it->second);
    }
    return earlier;
}

namespace {

double standard_deviation(const std::vector<double>& values, double mean) {
    double squares = 0;
    for (const double x : values) squares += (x - mean) * (x - mean);
    return std::sqrt(squares / static_cast<double>(values.size()));
}

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) /
           static_cast<double>(values.size());
}

//! Standard deviation over range. On a circle: of the arcs to the mean
//! direction.
double relative_spread(const Gene& gene, std::vector<double> values) {
    const double range = gene.upper - gene.lower;
    if (gene.is_circular) {
        const double to_radians = 2 * std::numbers::pi / range;
        double sine = 0, cosine = 0;
        for (const double x : values) {
            sine += std::sin(x * to_radians);
            cosine += std::cos(x * to_radians);
        }
        const double mean = std::atan2(sine, cosine) / to_radians;
        for (double& x : values) x = std::remainder(x - mean, range);
        return standard_deviation(values, 0) / range;
    }
    return standard_deviation(values, mean_of(values)) / range;
}

}  // namespace

GenerationSummary summarize(const Population& population,
                            const GeneSpace& genes) {
    GenerationSummary summary;
    std::vector<double> fitness;
    std::vector<std::size_t> succeeded;
    for (std::size_t slot = 0; slot < population.size(); ++slot)
        if (population[slot].status == Status::failed) {
            ++summary.failures;
        } else {
            fitness.push_back(population[slot].fitness);
            succeeded.push_back(slot);
        }
    if (succeeded.empty()) {
        const double none = std::numeric_limits<double>::quiet_NaN();
        summary.best = summary.best_standard_error = summary.mean =
            summary.spread = summary.diversity = none;
        return summary;
    }
    summary.best_slot = best_distinct(population, 1).front();
    summary.best = population[summary.best_slot].fitness;
    summary.best_standard_error = population[summary.best_slot].standard_error;
    // Negative: how far a constraint is failed, no amount of the objective.
    if (summary.best >= 0)
        std::erase_if(fitness, [](double f) { return f < 0; });
    summary.mean = mean_of(fitness);
    summary.spread = standard_deviation(fitness, summary.mean);
    std::vector<double> spreads;
    for (std::size_t g = 0; g < genes.size(); ++g) {
        if (!genes[g].is_free) continue;
        std::vector<double> values;
        for (const std::size_t slot : succeeded)
            values.push_back(population[slot].candidate.genome[g]);
        spreads.push_back(relative_spread(genes[g], std::move(values)));
    }
    summary.diversity = spreads.empty() ? 0 : mean_of(spreads);
    return summary;
}

}  // namespace ideotype
