// SPDX-License-Identifier: Apache-2.0
#include "integer_margin.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <boost/math/special_functions/erf.hpp>

#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

//! Probabilities are kept away from 0 and 0.5, where quantiles are infinite or
//! zero.
constexpr double smallest_probability = 1e-8;

//! Returns the probability of a standard normal number above x.
double upper_tail(double x) {
    return std::erfc(x / std::numbers::sqrt2) / 2;
}

//! Returns the number that a standard normal number exceeds with a probability
//! in (0, 0.5].
double upper_quantile(double probability) {
    const double p = std::clamp(probability, smallest_probability,
                                0.5 - smallest_probability);
    return std::numbers::sqrt2 * boost::math::erfc_inv(2 * p);
}

}  // namespace

double discrete_margin(std::size_t coordinates) {
    IDEOTYPE_EXPECT(coordinates > 0);
    return 1 - std::pow(0.73, 1 / static_cast<double>(coordinates));
}

IntegerMargin::IntegerMargin(std::size_t count, double margin)
    : largest_(static_cast<double>(count) - 1), margin_(margin) {
    IDEOTYPE_EXPECT(count >= 2);
    IDEOTYPE_EXPECT(margin > 0 && margin < 0.5);
}

double IntegerMargin::value(double position) const {
    // A position halfway between two values has the lower one.
    return std::clamp(std::ceil(position - 0.5), 0.0, largest_);
}

void IntegerMargin::centre(std::span<double> positions, double mean) {
    const double usual = value(mean);
    has_succeeded_ = false;
    double up = 0, down = 0, bias = 0;
    std::vector<double> moves(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const double own = value(positions[i]);
        const double move = own - positions[i];
        if (own == usual) {
            moves[i] = move;
            (move > 0 ? up : down) += move;
        } else {
            has_succeeded_ = true;
            bias += move;
            positions[i] = own;
        }
    }
    const double opposite = bias > 0 ? down : up;
    if (!(bias * opposite < 0)) return;
    const double share = std::min(1.0, -bias / opposite);
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (bias * moves[i] < 0) positions[i] += share * moves[i];
}

IntegerMargin::Marginal IntegerMargin::correct(Marginal updated) {
    IDEOTYPE_EXPECT(std::isfinite(updated.mean) && updated.deviation > 0);
    const double usual = value(updated.mean);
    if (usual == 0) return correct_at_end(updated, 0.5);
    if (usual == largest_) return correct_at_end(updated, largest_ - 0.5);
    return correct_between(updated, usual - 0.5, usual + 0.5);
}

//! The most probable value is the lowest or the highest one.
//! @param threshold position of the boundary of its part
IntegerMargin::Marginal IntegerMargin::correct_at_end(Marginal updated,
                                                      double threshold) {
    const double distance = std::abs(updated.mean - threshold);
    double mutation =
        std::max(upper_tail(distance / updated.deviation), margin_);
    if (!has_succeeded_) mutation = std::min(mutation, mutation_);
    mutation_ =
        std::clamp(mutation, smallest_probability, 0.5 - smallest_probability);
    // The deviation suffices to reach the other values from the middle of the
    // part.
    const double deviation =
        std::max(updated.deviation, 0.5 / upper_quantile(margin_));
    const double side = updated.mean < threshold ? -1 : 1;
    return {threshold + side * deviation * upper_quantile(mutation_),
            deviation};
}

//! There are lower and higher values than the most probable one.
IntegerMargin::Marginal IntegerMargin::correct_between(Marginal updated,
                                                       double lower,
                                                       double upper) {
    const double half = margin_ / 2;
    double below = upper_tail((updated.mean - lower) / updated.deviation);
    double above = upper_tail((upper - updated.mean) / updated.deviation);
    double usual = 1 - below - above;
    below = std::max(below, half);
    above = std::max(above, half);
    if (!has_succeeded_) usual = std::max(usual, 1 - mutation_);
    // The three probabilities sum to one again: what lies above their smallest
    // values shrinks in proportion.
    const double smallest = 2 * half + (has_succeeded_ ? half : 1 - mutation_);
    const double room = below + above + usual - smallest;
    const double excess = 1 - below - above - usual;
    const double change = room > 0 ? excess / room : 0;
    below += change * (below - half);
    above += change * (above - half);
    below = std::clamp(below, smallest_probability, 0.5 - smallest_probability);
    above = std::clamp(above, smallest_probability, 0.5 - smallest_probability);
    mutation_ = below + above;
    const double to_lower = upper_quantile(below);
    const double to_upper = upper_quantile(above);
    return {(lower * to_upper + upper * to_lower) / (to_lower + to_upper),
            (upper - lower) / (to_lower + to_upper)};
}

}  // namespace ideotype
