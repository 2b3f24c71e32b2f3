// SPDX-License-Identifier: Apache-2.0
#include "summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "ideotype/core/contract.hpp"
#include "order.hpp"
#include "shrinkage.hpp"

namespace ideotype {

namespace {

double standard_deviation(const std::vector<double>& values, double mean) {
    double squares = 0;
    for (const double x : values) squares += (x - mean) * (x - mean);
    return std::sqrt(squares / static_cast<double>(values.size()));
}

//! Returns the standard deviation of a gene relative to its range. For a
//! circular gene, deviations are arcs from the mean direction. For a choice, it
//! is derived from the probability that two values differ, and is that of a
//! uniform number if all values are equally frequent.
double relative_spread(const Gene& gene, std::vector<double> values) {
    const double range = gene.upper - gene.lower;
    if (gene.is_choice()) {
        std::map<double, double> counts;
        for (const double x : values) ++counts[x];
        const auto size = static_cast<double>(values.size());
        double alike = 0;
        for (const auto& [value, count] : counts)
            alike += count / size * (count / size);
        const double largest = 1 - 1 / static_cast<double>(gene.count());
        return std::sqrt((1 - alike) / largest / 12);
    }
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
    return standard_deviation(values, average(values)) / range;
}

using Point = std::vector<double>;

//! Returns the volume between points and a reference above all of them, in the
//! first coordinates. Points are sorted by the last of these coordinates. The
//! slice between two consecutive points is as thick as their distance; its base
//! is the volume of the points below, in one dimension less.
double sum_slices(std::vector<Point> points, const Point& reference,
                  std::size_t coordinates) {
    IDEOTYPE_EXPECT(!points.empty() && coordinates > 0);
    const std::size_t last = coordinates - 1;
    std::sort(
        points.begin(), points.end(),
        [&](const Point& a, const Point& b) { return a[last] < b[last]; });
    if (last == 0) return reference[0] - points.front()[0];
    double sum = 0, lowest = std::numeric_limits<double>::infinity();
    std::vector<Point> below;
    for (std::size_t i = 0; i < points.size(); ++i) {
        below.push_back(points[i]);
        lowest = std::min(lowest, points[i][0]);
        const double top =
            i + 1 < points.size() ? points[i + 1][last] : reference[last];
        const double height = top - points[i][last];
        if (!(height > 0)) continue;
        sum += height * (last == 1 ? reference[0] - lowest
                                   : sum_slices(below, reference, last));
    }
    return sum;
}

bool is_feasible(const Individual& individual) {
    return individual.status == Status::done && !(individual.violation > 0);
}

}  // namespace

GenerationSummary summarize(const Population& population,
                            const GeneSpace& genes, Sense sense) {
    GenerationSummary summary;
    // Copies of a genome count as one evaluation.
    std::set<Genome> genomes;
    for (const Individual& individual : population)
        genomes.insert(individual.candidate.genome);
    summary.evaluations = static_cast<std::uint32_t>(genomes.size());
    std::vector<const Individual*> succeeded;
    for (const Individual& individual : population)
        if (individual.status != Status::failed)
            succeeded.push_back(&individual);
    summary.failures =
        static_cast<std::uint32_t>(population.size() - succeeded.size());
    if (succeeded.empty()) {
        const double none = std::numeric_limits<double>::quiet_NaN();
        summary.best = summary.best_standard_error = summary.mean =
            summary.spread = summary.diversity = none;
        summary.expected_best = {none, none};
        return summary;
    }
    // The best row, and an estimate of its value without selection bias.
    summary.best_slot = best_distinct(population, 1, {sense}).front();
    const Individual& best = population[summary.best_slot];
    summary.best = best.objectives.front().mean;
    summary.best_standard_error = best.objectives.front().standard_error;
    summary.violation = best.violation;
    summary.expected_best = shrink(population, summary.best_slot);
    // Mean and standard deviation of the plants with which the best row is
    // compared.
    std::vector<double> values;
    for (const Individual* individual : succeeded)
        if (best.violation > 0 || individual->violation == 0)
            values.push_back(individual->objectives.front().mean);
    summary.mean = average(values);
    summary.spread = standard_deviation(values, summary.mean);
    // Diversity of the free genes.
    std::vector<double> spreads;
    for (std::size_t g = 0; g < genes.size(); ++g) {
        if (!genes[g].is_free) continue;
        std::vector<double> alleles;
        for (const Individual* individual : succeeded)
            alleles.push_back(individual->candidate.genome[g]);
        spreads.push_back(relative_spread(genes[g], std::move(alleles)));
    }
    summary.diversity = spreads.empty() ? 0 : average(spreads);
    return summary;
}

double hypervolume(std::vector<Point> points, Point reference,
                   const std::vector<Sense>& senses) {
    IDEOTYPE_EXPECT(reference.size() == senses.size());
    const auto minimise = [&](Point& point) {
        for (std::size_t k = 0; k < senses.size(); ++k)
            if (senses[k] == Sense::maximise) point[k] = -point[k];
    };
    minimise(reference);
    for (Point& point : points) {
        IDEOTYPE_EXPECT(point.size() == senses.size());
        minimise(point);
    }
    std::erase_if(points, [&](const Point& point) {
        for (std::size_t k = 0; k < point.size(); ++k)
            if (!(point[k] < reference[k])) return true;
        return false;
    });
    if (points.empty()) return 0;
    return sum_slices(std::move(points), reference, senses.size());
}

Estimate hypervolume(const Population& population, const Point& reference,
                     const std::vector<Sense>& senses) {
    const std::size_t objectives = senses.size();
    // Computes the volume from all randomisations, or from all but one.
    const auto volume = [&](std::size_t left_out, std::size_t count) {
        std::vector<Point> points;
        for (const Individual& individual : population) {
            if (!is_feasible(individual)) continue;
            Point& point = points.emplace_back();
            for (std::size_t k = 0; k < objectives; ++k) {
                const double mean = individual.objectives[k].mean;
                point.push_back(
                    left_out < count
                        ? mean -
                              (individual.randomisations[k * count + left_out] -
                               mean) /
                                  static_cast<double>(count - 1)
                        : mean);
            }
        }
        return hypervolume(std::move(points), reference, senses);
    };
    std::size_t count = 0;
    for (const Individual& individual : population)
        if (is_feasible(individual))
            count = individual.randomisations.size() / objectives;
    const double whole = volume(0, 0);
    if (count < 2) return {whole, std::numeric_limits<double>::quiet_NaN()};
    // Use the jackknife over randomisations.
    std::vector<double> pseudo;
    const auto n = static_cast<double>(count);
    for (std::size_t r = 0; r < count; ++r)
        pseudo.push_back(n * whole - (n - 1) * volume(r, count));
    return {whole, estimate(pseudo).standard_error};
}

Point find_worst(const Population& population,
                 const std::vector<Sense>& senses) {
    Point worst;
    for (const Individual& individual : population) {
        if (individual.status != Status::done) continue;
        for (std::size_t k = 0; k < senses.size(); ++k) {
            const double value = individual.objectives[k].mean;
            if (worst.size() == k)
                worst.push_back(value);
            else if (is_better(worst[k], value, senses[k]))
                worst[k] = value;
        }
    }
    return worst;
}

Summarizer::Summarizer(GeneSpace genes, std::vector<Sense> senses,
                       std::vector<double> reference)
    : genes_(std::move(genes)),
      senses_(std::move(senses)),
      reference_(std::move(reference)) {
    IDEOTYPE_EXPECT(!senses_.empty());
    IDEOTYPE_EXPECT(reference_.empty() || reference_.size() == senses_.size());
}

GenerationSummary Summarizer::operator()(const Population& generation) {
    GenerationSummary summary = summarize(generation, genes_, senses_.front());
    if (senses_.size() == 1) return summary;
    if (reference_.empty()) reference_ = find_worst(generation, senses_);
    if (reference_.empty()) return summary;
    front_.insert(front_.end(), generation.begin(), generation.end());
    const std::vector<std::size_t> level = fronts(front_, senses_);
    std::size_t i = 0;
    std::erase_if(front_, [&](const Individual&) { return level[i++] > 0; });
    const auto [mean, error] = hypervolume(front_, reference_, senses_);
    summary.hypervolume = mean;
    summary.hypervolume_standard_error = error;
    return summary;
}

}  // namespace ideotype
