// SPDX-License-Identifier: Apache-2.0
#include "arm.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/mapped.hpp"
#include "ideotype/core/random.hpp"
#include "search/order.hpp"
#include "search/points.hpp"

namespace ideotype {

namespace {

using Eigen::VectorXd;

//! Returns the mean of objective 0 over the better half of some rows, or the
//! worst possible value if no row succeeded and meets all constraints.
double average_better_half(const Population& rows,
                           const std::vector<Sense>& senses) {
    IDEOTYPE_EXPECT(!rows.empty());
    const std::size_t half = (rows.size() + 1) / 2;
    double sum = 0;
    std::size_t count = 0;
    const std::vector<std::uint32_t> order = ranking(rows, senses);
    for (std::size_t i = 0; i < half; ++i) {
        const Individual& row = rows[order[i]];
        if (row.status == Status::failed || row.violation > 0) break;
        sum += row.objectives.front().mean;
        ++count;
    }
    if (count > 0) return sum / static_cast<double>(count);
    const double worst = std::numeric_limits<double>::infinity();
    return senses.front() == Sense::maximise ? -worst : worst;
}

}  // namespace

Arm::Arm(const UnboundedGenes& coordinates, const Genome& start,
         std::size_t population)
    : Arm(coordinates, to_vector(coordinates.to_coordinates(start)),
          first_step * to_vector(coordinates.first_steps()), population) {}

Arm::Arm(const UnboundedGenes& coordinates, const VectorXd& mean,
         const VectorXd& deviations, std::size_t population)
    : population_(population), coordinates_(coordinates) {
    const GeneSpace& genes = coordinates.genes();
    std::size_t discrete = coordinates.choices().size();
    for (const std::size_t gene : coordinates.free())
        if (genes[gene].is_discrete()) ++discrete;
    if (!coordinates.free().empty())
        numbers_.emplace(mean, deviations, population);
    for (std::size_t i = 0; i < coordinates.free().size(); ++i) {
        const Gene& gene = genes[coordinates.free()[i]];
        if (gene.is_discrete())
            integers_.push_back({i,
                                 static_cast<double>(gene.count()),
                                 {gene.count(), discrete_margin(discrete)}});
    }
    if (coordinates.choices().empty()) return;
    std::vector<std::vector<double>> probabilities;
    for (const std::size_t i : coordinates.choices()) {
        const std::size_t count = genes[i].count();
        probabilities.emplace_back(count, 1 / static_cast<double>(count));
    }
    choices_.emplace(std::move(probabilities), discrete_margin(discrete));
}

const Arm::Point& Arm::point(std::uint64_t seed, std::uint32_t generation,
                             std::uint32_t slot, std::size_t plant) {
    IDEOTYPE_EXPECT(plant < population_);
    points_.resize(population_);
    std::optional<Point>& drawn = points_[plant];
    if (drawn) return *drawn;
    drawn.emplace();
    RandomStream stream(seed, Purpose::sample, generation,
                        slot + static_cast<std::uint32_t>(plant));
    if (numbers_) {
        const VectorXd x =
            numbers_->sample(draw_normal(stream, coordinates_.free().size()));
        drawn->numbers.assign(x.begin(), x.end());
    }
    if (choices_) drawn->choices = choices_->draw(stream);
    return *drawn;
}

Candidate Arm::make_candidate(const Point& point,
                              const Genome& baseline) const {
    Genome genome = coordinates_.to_genome(point.numbers, baseline);
    for (std::size_t i = 0; i < point.choices.size(); ++i) {
        const std::size_t gene = coordinates_.choices()[i];
        genome[gene] = coordinates_.genes()[gene].lower +
                       static_cast<double>(point.choices[i]);
    }
    return {std::move(genome), Origin::sample};
}

Candidate Arm::candidate(std::uint64_t seed, std::uint32_t generation,
                         std::uint32_t slot, std::size_t plant,
                         const Genome& baseline) {
    return make_candidate(point(seed, generation, slot, plant), baseline);
}

Candidate Arm::centre(const Genome& baseline) const {
    Point centre;
    if (numbers_)
        centre.numbers.assign(numbers_->mean().begin(), numbers_->mean().end());
    if (choices_) centre.choices = choices_->mode();
    return make_candidate(centre, baseline);
}

double Arm::extent() const {
    double extent = 0;
    bool has_real = false;
    for (std::size_t i = 0; i < coordinates_.free().size(); ++i) {
        if (coordinates_.genes()[coordinates_.free()[i]].is_discrete())
            continue;
        has_real = true;
        extent = std::max(extent,
                          numbers_->deviations()[static_cast<Eigen::Index>(i)]);
    }
    return has_real ? extent : std::numeric_limits<double>::infinity();
}

void Arm::grow() {
    population_ *= 2;
    if (numbers_) numbers_->set_population(population_);
    course_.clear();
}

void Arm::learn(const Population& rows, const std::vector<Sense>& senses,
                std::uint64_t seed, std::uint32_t generation,
                std::uint32_t slot) {
    IDEOTYPE_EXPECT(rows.size() == population_);
    std::vector<Point> ranked;
    for (const std::uint32_t i : ranking(rows, senses))
        ranked.push_back(point(seed, generation, slot, i));
    if (numbers_) update_numbers(ranked);
    if (choices_) choices_->update(mapped(ranked, &Point::choices));
    points_.clear();
    course_.push_back(average_better_half(rows, senses));
}

void Arm::update_numbers(const std::vector<Point>& ranked) {
    Eigen::MatrixXd points(numbers_->mean().size(), ranked.size());
    for (std::size_t i = 0; i < ranked.size(); ++i)
        points.col(static_cast<Eigen::Index>(i)) = to_vector(ranked[i].numbers);
    // The positions of IntegerMargin are numbers of values.
    for (Integer& integer : integers_) {
        const auto row = static_cast<Eigen::Index>(integer.coordinate);
        std::vector<double> positions;
        for (std::size_t i = 0; i < ranked.size() / 2; ++i)
            positions.push_back(points(row, static_cast<Eigen::Index>(i)) *
                                    integer.count -
                                0.5);
        integer.margin.centre(positions,
                              numbers_->mean()[row] * integer.count - 0.5);
        for (std::size_t i = 0; i < positions.size(); ++i)
            points(row, static_cast<Eigen::Index>(i)) =
                (positions[i] + 0.5) / integer.count;
    }
    numbers_->update(points);
    for (Integer& integer : integers_) {
        const auto row = static_cast<Eigen::Index>(integer.coordinate);
        const auto [mean, deviation] = integer.margin.correct(
            {numbers_->mean()[row] * integer.count - 0.5,
             numbers_->deviations()[row] * integer.count});
        numbers_->set_marginal(integer.coordinate, (mean + 0.5) / integer.count,
                               deviation / integer.count);
    }
}

bool Arm::gains_nothing(Sense sense) const {
    constexpr std::size_t window = 20;
    if (course_.size() < 2 * window) return false;
    // Compare the means of two windows of generations, using the standard error
    // of their difference.
    const auto recent = std::span(course_).last(2 * window);
    const auto before = recent.first(window), last = recent.last(window);
    const double mean_last = average(last);
    const double mean_before = average(before);
    double squares = 0;
    for (std::size_t i = 0; i < window; ++i)
        squares += (last[i] - mean_last) * (last[i] - mean_last) +
                   (before[i] - mean_before) * (before[i] - mean_before);
    const double error =
        std::sqrt(squares / static_cast<double>(window * (window - 1)));
    const double gain = sense == Sense::maximise ? mean_last - mean_before
                                                 : mean_before - mean_last;
    return !(gain > error);
}

}  // namespace ideotype
