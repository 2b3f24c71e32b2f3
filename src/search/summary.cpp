// SPDX-License-Identifier: Apache-2.0
#include "summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <set>

#include "order.hpp"

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
                            const GeneSpace& genes, Sense sense) {
    GenerationSummary summary;
    std::set<Genome> genomes;
    for (const Individual& each : population)
        genomes.insert(each.candidate.genome);
    summary.evaluations = static_cast<std::uint32_t>(genomes.size());
    std::vector<const Individual*> succeeded;
    for (const Individual& each : population)
        if (each.status != Status::failed) succeeded.push_back(&each);
    summary.failures =
        static_cast<std::uint32_t>(population.size() - succeeded.size());
    if (succeeded.empty()) {
        const double none = std::numeric_limits<double>::quiet_NaN();
        summary.best = summary.best_standard_error = summary.mean =
            summary.spread = summary.diversity = none;
        return summary;
    }
    summary.best_slot = best_distinct(population, 1, {sense}).front();
    const Individual& best = population[summary.best_slot];
    summary.best = best.objectives.front().mean;
    summary.best_standard_error = best.objectives.front().standard_error;
    summary.violation = best.violation;
    std::vector<double> values;
    for (const Individual* each : succeeded)
        if (best.violation > 0 || each->violation == 0)
            values.push_back(each->objectives.front().mean);
    summary.mean = mean_of(values);
    summary.spread = standard_deviation(values, summary.mean);
    std::vector<double> spreads;
    for (std::size_t g = 0; g < genes.size(); ++g) {
        if (!genes[g].is_free) continue;
        std::vector<double> of_gene;
        for (const Individual* each : succeeded)
            of_gene.push_back(each->candidate.genome[g]);
        spreads.push_back(relative_spread(genes[g], std::move(of_gene)));
    }
    summary.diversity = spreads.empty() ? 0 : mean_of(spreads);
    return summary;
}

}  // namespace ideotype
