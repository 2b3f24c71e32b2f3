// SPDX-License-Identifier: Apache-2.0
#include "surface_arm.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/random.hpp"
#include "search/points.hpp"

namespace ideotype {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

}  // namespace

SurfaceArm::SurfaceArm(const UnboundedGenes& coordinates, const Genome& start,
                       std::size_t pairs)
    : coordinates_(coordinates),
      pairs_(pairs),
      centre_(to_vector(coordinates.to_coordinates(start))),
      previous_(centre_),
      scales_(first_step * to_vector(coordinates.first_steps())) {
    IDEOTYPE_EXPECT(pairs > 0);
    IDEOTYPE_EXPECT(centre_.size() > 0);
}

VectorXd SurfaceArm::point(std::uint64_t seed, std::uint32_t generation,
                           std::uint32_t slot) const {
    IDEOTYPE_EXPECT(slot < size());
    if (slot == 0) return centre_;
    if (slot < count_centres()) return previous_;
    // Both points of a pair have the random numbers of its first slot.
    const std::uint32_t side = (slot - count_centres()) % 2;
    RandomStream stream(seed, Purpose::sample, generation, slot - side);
    const VectorXd step = deviations().cwiseProduct(
        draw_normal(stream, static_cast<std::size_t>(centre_.size())));
    return centre_ + (side == 0 ? 1.0 : -1.0) * step;
}

Candidate SurfaceArm::make_candidate(const VectorXd& point,
                                     const Genome& baseline) const {
    return {coordinates_.to_genome({point.begin(), point.end()}, baseline),
            Origin::sample};
}

Candidate SurfaceArm::candidate(std::uint64_t seed, std::uint32_t generation,
                                std::uint32_t slot,
                                const Genome& baseline) const {
    return make_candidate(point(seed, generation, slot), baseline);
}

Candidate SurfaceArm::centre(const Genome& baseline) const {
    return make_candidate(centre_, baseline);
}

void SurfaceArm::learn(const Population& rows, Sense sense, std::uint64_t seed,
                       std::uint32_t generation) {
    IDEOTYPE_EXPECT(rows.size() == size());
    const double sign = sense == Sense::maximise ? 1 : -1;
    std::vector<std::uint32_t> done;
    for (std::uint32_t slot = 0; slot < rows.size(); ++slot)
        if (rows[slot].status == Status::done) done.push_back(slot);
    const auto count = static_cast<Index>(done.size());
    SurfaceRows learnt{MatrixXd(centre_.size(), count), VectorXd(count)};
    for (Index i = 0; i < count; ++i) {
        const std::uint32_t slot = done[static_cast<std::size_t>(i)];
        learnt.points.col(i) = point(seed, generation, slot);
        learnt.values[i] = sign * rows[slot].objectives.front().mean;
    }
    const bool has_both_centres =
        count_centres() == 2 && count >= 2 && done[0] == 0 && done[1] == 1;
    if (has_both_centres) adapt_region(learnt.values[0] - learnt.values[1]);
    ++generations_;
    if (count >= 2) {
        // The surface is a local one, so that old rows count less.
        constexpr double ageing = 0.9;
        for (SurfaceRows& older : rows_) older.weight *= ageing;
        rows_.push_back(std::move(learnt));
    }
    if (!rows_.empty()) move();
}

void SurfaceArm::adapt_region(double gain) {
    constexpr double poor = 0.25, good = 0.75, shrinkage = 0.85;
    // A step of zero predicts nothing.
    const double ratio = predicted_ > 0 ? gain / predicted_ : 0;
    if (ratio < poor)
        radius_ *= shrinkage;
    else if (ratio > good && is_limited_)
        radius_ = std::min(1.0, radius_ / shrinkage);
}

void SurfaceArm::move() {
    // Rows as seen from the centre, in units of the deviations.
    std::vector<SurfaceRows> seen = rows_;
    for (SurfaceRows& rows : seen)
        rows.points = deviations().cwiseInverse().asDiagonal() *
                      (rows.points.colwise() - centre_);
    const ResponseSurface surface = fit_surface(seen);
    // In a direction known from few rows, slopes and noise are alike; a step of
    // half a deviation per coordinate does not follow the noise far.
    constexpr double half_deviation = 0.5;
    const double limit =
        half_deviation * std::sqrt(static_cast<double>(centre_.size()));
    const VectorXd step = surface.maximise(limit);
    predicted_ = surface.at(step);
    constexpr double nearly = 0.9;
    is_limited_ = step.norm() > nearly * limit;
    previous_ = std::exchange(
        centre_, (centre_ + deviations().cwiseProduct(step)).eval());
}

}  // namespace ideotype
