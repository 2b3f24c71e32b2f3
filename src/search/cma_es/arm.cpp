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

//! The standard deviation at the beginning, relative to the range of a gene.
constexpr double first_step = 0.2;

VectorXd to_vector(const std::vector<double>& x) {
    return Eigen::Map<const VectorXd>(x.data(),
                                      static_cast<Eigen::Index>(x.size()));
}

VectorXd standard_normal(RandomStream stream, std::size_t size) {
    VectorXd x(static_cast<Eigen::Index>(size));
    for (Eigen::Index i = 0; i < x.size(); i += 2) {
        const auto [first, second] = stream.normal();
        x[i] = first;
        if (i + 1 < x.size()) x[i + 1] = second;
    }
    return x;
}

//! Returns the mean of objective 0 over the better half of some rows; the worst
//! possible value if none of the better half succeeded and meets all
//! constraints.
double better_half(const Population& rows, const std::vector<Sense>& senses) {
    IDEOTYPE_EXPECT(!rows.empty());
    const std::size_t half = (rows.size() + 1) / 2;
    double sum = 0;
    std::size_t count = 0;
    const std::vector<std::uint32_t> order = ranking(rows, senses);
    for (std::size_t i = 0; i < half; ++i) {
        const Individual& each = rows[order[i]];
        if (each.status == Status::failed || each.violation > 0) break;
        sum += each.objectives.front().mean;
        ++count;
    }
    if (count > 0) return sum / static_cast<double>(count);
    const double worst = std::numeric_limits<double>::infinity();
    return senses.front() == Sense::maximise ? -worst : worst;
}

}  // namespace

Candidate plant_at(const VectorXd& point, const UnboundedGenes& coordinates,
                   const Genome& baseline) {
    return {coordinates.genome({point.begin(), point.end()}, baseline),
            Origin::sample};
}

Arm::Arm(const UnboundedGenes& coordinates, const Genome& start,
         std::size_t population)
    : population_(population),
      distribution_(to_vector(coordinates.of(start)),
                    first_step * to_vector(coordinates.first_steps()),
                    population) {}

const VectorXd& Arm::point(std::uint64_t seed, std::uint32_t generation,
                           std::uint32_t slot, std::size_t plant) {
    IDEOTYPE_EXPECT(plant < population_);
    points_.resize(population_);
    VectorXd& x = points_[plant];
    if (x.size() == 0)
        x = distribution_.sample(standard_normal(
            RandomStream(seed, Purpose::sample, generation,
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
    course_.push_back(better_half(rows, senses));
}

bool Arm::gains_nothing(Sense sense) const {
    constexpr std::size_t window = 20;
    if (course_.size() < 2 * window) return false;
    const auto both = std::span(course_).last(2 * window);
    const auto before = both.first(window), last = both.last(window);
    const double now = mean_of(last);
    const double then = mean_of(before);
    double squares = 0;
    for (std::size_t i = 0; i < window; ++i)
        squares += (last[i] - now) * (last[i] - now) +
                   (before[i] - then) * (before[i] - then);
    const double error =
        std::sqrt(squares / static_cast<double>(window * (window - 1)));
    const double gain = sense == Sense::maximise ? now - then : then - now;
    return !(gain > error);
}

}  // namespace ideotype
