// SPDX-License-Identifier: Apache-2.0
#include "shrinkage.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

using Rows = std::vector<const Individual*>;

//! Returns the number of randomisations of objective 0 that all rows share, or
//! 0 if it is not known.
std::size_t shared_randomisations(const Rows& rows) {
    const auto count = [](const Individual& row) {
        return row.randomisations.size() / row.objectives.size();
    };
    const std::size_t first = count(*rows.front());
    const bool is_shared = std::ranges::all_of(
        rows, [&](const Individual* row) { return count(*row) == first; });
    return is_shared ? first : 0;
}

//! Returns the mean square of standard errors of objective 0.
double error_variance(const Rows& rows) {
    double sum = 0;
    for (const Individual* row : rows)
        sum += row->objectives.front().standard_error *
               row->objectives.front().standard_error;
    return sum / static_cast<double>(rows.size());
}

//! Returns the noise variance of one row, without noise that rows share.
double noise_variance(const Rows& rows) {
    const std::size_t count = shared_randomisations(rows);
    if (count < 2) return error_variance(rows);
    const auto n = static_cast<double>(rows.size());
    const auto draws = static_cast<double>(count);
    std::vector<double> shared(count);
    for (const Individual* row : rows)
        for (std::size_t r = 0; r < count; ++r)
            shared[r] += row->randomisations[r] / n;
    double squares = 0;
    for (const Individual* row : rows) {
        double mean = 0;
        for (std::size_t r = 0; r < count; ++r)
            mean += (row->randomisations[r] - shared[r]) / draws;
        for (std::size_t r = 0; r < count; ++r) {
            const double off = row->randomisations[r] - shared[r] - mean;
            squares += off * off;
        }
    }
    // (n - 1) (draws - 1) degrees of freedom; a row is a mean of draws.
    return squares / ((n - 1) * (draws - 1) * draws);
}

}  // namespace

Estimate shrunken(const Population& population, std::size_t chosen) {
    IDEOTYPE_EXPECT(population.at(chosen).status == Status::done);
    const Individual& best = population[chosen];
    Rows rows;
    for (const Individual& each : population)
        if (each.status == Status::done &&
            (best.violation > 0 || !(each.violation > 0)))
            rows.push_back(&each);
    const Estimate given = best.objectives.front();
    const auto n = static_cast<double>(rows.size());
    if (n < 2) return given;
    double mean = 0;
    for (const Individual* row : rows) mean += row->objectives.front().mean / n;
    double squares = 0;
    for (const Individual* row : rows)
        squares += std::pow(row->objectives.front().mean - mean, 2);
    const double spread = squares / (n - 1), noise = noise_variance(rows);
    const double shared = std::max(0., error_variance(rows) - noise);
    if (noise <= 0) return given;
    // Too few rows do not separate noise from differences between plants.
    if (n < 4) return {mean, std::sqrt(spread + shared)};
    const double off = given.mean - mean;
    const double taken =
        (n - 3) / (n - 1) * (noise < spread ? noise / spread : 1);
    const double variance = noise * (1 - (n - 1) / n * taken) +
                            2 / (n - 3) * taken * taken * off * off;
    return {mean + (1 - taken) * off, std::sqrt(variance + shared)};
}

}  // namespace ideotype
