// SPDX-License-Identifier: Apache-2.0
#include "variation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ideotype {

namespace {

double repaired(const Gene& gene, double value) {
    return gene.is_circular ? wrapped(gene, value)
                            : std::clamp(value, gene.lower, gene.upper);
}

//! The spread factor of simulated binary crossover, bounded so that a child
//! stays within `room` of the couple's mean, both in units of half of the
//! parents' distance (Deb and Agrawal 1995, eq. 9 with bounds as in NSGA-II).
double spread_factor(double u, double index, double room) {
    const double power = index + 1;
    const double alpha = std::isfinite(room) ? 2 - std::pow(room, -power) : 2.0;
    return u <= 1 / alpha ? std::pow(u * alpha, 1 / power)
                          : std::pow(1 / (2 - u * alpha), 1 / power);
}

}  // namespace

std::pair<double, double> cross(const Gene& gene, double a, double b, double u,
                                double index) {
    const double distance = difference(gene, a, b);
    if (std::abs(distance) < 1e-14 * (gene.upper - gene.lower)) return {a, b};
    const double mean = a + distance / 2;
    const double half = std::abs(distance) / 2;
    const double endless = std::numeric_limits<double>::infinity();
    const auto room = [&](double bound) {
        return gene.is_circular ? endless
                                : std::max(1.0, std::abs(bound - mean) / half);
    };
    const double low = mean - half * spread_factor(u, index, room(gene.lower));
    const double high = mean + half * spread_factor(u, index, room(gene.upper));
    const double first = repaired(gene, distance > 0 ? low : high);
    const double second = repaired(gene, distance > 0 ? high : low);
    return {first, second};
}

double mutate(const Gene& gene, double value, double u, double index) {
    const double range = gene.upper - gene.lower;
    const double power = index + 1;
    const auto missing = [&](double room) {
        // A circle has no end, so no step is cut off.
        return gene.is_circular ? 0.0 : std::pow(1 - room / range, power);
    };
    double step = 0;
    if (u < 0.5) {
        const double rest = missing(value - gene.lower);
        step = std::pow(2 * u + (1 - 2 * u) * rest, 1 / power) - 1;
    } else {
        const double rest = missing(gene.upper - value);
        step = 1 - std::pow(2 * (1 - u) + (2 * u - 1) * rest, 1 / power);
    }
    return repaired(gene, value + step * range);
}

}  // namespace ideotype
