// SPDX-License-Identifier: Apache-2.0
#include "shrinkage.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

using Rows = std::vector<const Individual*>;

//! Returns the number of randomisations of the first objective, if all rows
//! have the same number; else 0.
std::size_t count_shared_randomisations(const Rows& rows) {
    const auto count = [](const Individual& row) {
        return row.randomisations.size() / row.objectives.size();
    };
    const std::size_t first = count(*rows.front());
    const bool is_shared = std::ranges::all_of(
        rows, [&](const Individual* row) { return count(*row) == first; });
    return is_shared ? first : 0;
}

//! Returns the mean of the squared standard errors of objective 0.
double error_variance(const Rows& rows) {
    double sum = 0;
    for (const Individual* row : rows)
        sum += row->objectives.front().standard_error *
               row->objectives.front().standard_error;
    return sum / static_cast<double>(rows.size());
}

//! Estimates the noise variance of one row, without the noise that all rows
//! share, by a two-way analysis of variance over rows and randomisations.
double estimate_noise(const Rows& rows) {
    const std::size_t count = count_shared_randomisations(rows);
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
            const double residual = row->randomisations[r] - shared[r] - mean;
            squares += residual * residual;
        }
    }
    // There are (n - 1) (draws - 1) degrees of freedom, and each row is a mean
    // of `draws` values.
    return squares / ((n - 1) * (draws - 1) * draws);
}

}  // namespace

Estimate shrink(const Population& population, std::size_t chosen) {
    IDEOTYPE_EXPECT(population.at(chosen).status == Status::done);
    const Individual& best = population[chosen];
    Rows rows;
    for (const Individual& row : population)
        if (row.status == Status::done &&
            (best.violation > 0 || !(row.violation > 0)))
            rows.push_back(&row);
    const Estimate given = best.objectives.front();
    const auto n = static_cast<double>(rows.size());
    if (n < 2) return given;
    double mean = 0;
    for (const Individual* row : rows) mean += row->objectives.front().mean / n;
    double squares = 0;
    for (const Individual* row : rows)
        squares += std::pow(row->objectives.front().mean - mean, 2);
    const double spread = squares / (n - 1), noise = estimate_noise(rows);
    const double shared = std::max(0., error_variance(rows) - noise);
    if (noise <= 0) return given;
    // With too few rows, noise cannot be separated from differences between
    // plants.
    if (n < 4) return {mean, std::sqrt(spread + shared)};
    const double deviation = given.mean - mean;
    const double factor =
        (n - 3) / (n - 1) * (noise < spread ? noise / spread : 1);
    const double variance =
        noise * (1 - (n - 1) / n * factor) +
        2 / (n - 3) * factor * factor * deviation * deviation;
    return {mean + (1 - factor) * deviation, std::sqrt(variance + shared)};
}

}  // namespace ideotype
