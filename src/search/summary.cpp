#include "ideotype/search/summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <set>

#include "ideotype/search/order.hpp"

namespace ideotype {

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
    std::set<Genome> genomes;
    for (const Individual& each : population)
        genomes.insert(each.candidate.genome);
    summary.evaluations = static_cast<std::uint32_t>(genomes.size());
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
