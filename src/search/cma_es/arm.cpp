// SPDX-License-Identifier: Apache-2.0
#include "arm.hpp"

#include <cmath>
#include <limits>
#include <span>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/random.hpp"
#include "search/order.hpp"

namespace ideotype {

namespace {

using Eigen::VectorXd;

//! The initial standard deviation, relative to the range of a gene.
constexpr double first_step = 0.2;

VectorXd to_vector(const std::vector<double>& x) {
    return Eigen::Map<const VectorXd>(x.data(),
                                      static_cast<Eigen::Index>(x.size()));
}

VectorXd draw_normal(RandomStream stream, std::size_t size) {
    VectorXd x(static_cast<Eigen::Index>(size));
    for (Eigen::Index i = 0; i < x.size(); i += 2) {
        const auto [first, second] = stream.normal();
        x[i] = first;
        if (i + 1 < x.size()) x[i + 1] = second;
    }
    return x;
}

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

Candidate make_candidate(const VectorXd& point,
                         const UnboundedGenes& coordinates,
                         const Genome& baseline) {
    return {coordinates.to_genome({point.begin(), point.end()}, baseline),
            Origin::sample};
}

Arm::Arm(const UnboundedGenes& coordinates, const Genome& start,
         std::size_t population)
    : population_(population),
      distribution_(to_vector(coordinates.to_coordinates(start)),
                    first_step * to_vector(coordinates.first_steps()),
                    population) {}

const VectorXd& Arm::point(std::uint64_t seed, std::uint32_t generation,
                           std::uint32_t slot, std::size_t plant) {
    IDEOTYPE_EXPECT(plant < population_);
    points_.resize(population_);
    VectorXd& x = points_[plant];
    if (x.size() == 0)
        x = distribution_.sample(
            draw_normal(RandomStream(seed, Purpose::sample, generation,
                                     slot + static_cast<std::uint32_t>(plant)),
                        static_cast<std::size_t>(distribution_.mean().size())));
    return x;
}

void Arm::grow() {
    population_ *= 2;
    distribution_.set_population(population_);
    course_.clear();
}

void Arm::learn(const Population& rows, const std::vector<Sense>& senses,
                std::uint64_t seed, std::uint32_t generation,
                std::uint32_t slot) {
    IDEOTYPE_EXPECT(rows.size() == population_);
    const std::vector<std::uint32_t> order = ranking(rows, senses);
    Eigen::MatrixXd ranked(distribution_.mean().size(), order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        ranked.col(static_cast<Eigen::Index>(i)) =
            point(seed, generation, slot, order[i]);
    distribution_.update(ranked);
    points_.clear();
    course_.push_back(average_better_half(rows, senses));
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
