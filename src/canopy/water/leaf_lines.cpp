// SPDX-License-Identifier: Apache-2.0
#include "leaf_lines.hpp"

#include <algorithm>
#include <cmath>

namespace ideotype {

void LeafLines::clear() {
    for (Class& each : classes_) each = Class{};
}

void LeafLines::add(std::uint32_t group, const LeafAir::Point& point,
                    double area) {
    // Rounding may make the shaded area of a place slightly negative.
    if (!(area > 0)) return;
    Mean& mean = of(group).means[point.cosine > 0 ? 1 : 0];
    mean.area += area;
    mean.ppfd += area * point.ppfd;
    mean.cosine += area * point.cosine;
}

//! Finds the mean leaves of classes. A class without leaves in sun or shade
//! gets a leaf in the dark.
void LeafLines::find_points(const std::vector<LeafResponse>& responses) {
    for (std::uint32_t c = 0; c < classes_.size(); ++c) {
        Class& leaves = classes_[c];
        const auto group = air_.largest_of(c);
        leaves.is_used =
            group && leaves.means[0].area + leaves.means[1].area > 0;
        if (!leaves.is_used) continue;
        for (std::size_t i = 0; i < 2; ++i) {
            const Mean& mean = leaves.means[i];
            LeafAir::Point& point = leaves.points[i];
            point = {air_.mean_place(c)};
            if (mean.area > 0) {
                point.ppfd = mean.ppfd / mean.area;
                point.cosine = mean.cosine / mean.area;
            }
            if (!responses.empty())
                expand(responses[*group], {&point.ppfd, 1}, &point.gross.value,
                       &point.gross.slope, &point.gross.curvature);
        }
    }
}

void LeafLines::draw(Class& leaves) {
    const auto& [shade, sun] = leaves.points;
    const double light = sun.ppfd - shade.ppfd;
    const double gross = sun.gross.value - shade.gross.value;
    // The slope between two leaves that are nearly alike would consist mostly
    // of rounding errors.
    constexpr double least = 0.1;
    const std::size_t points =
        std::max(std::abs(light), std::abs(gross)) > least ? 2 : 1;
    LeafAir::Fluxes found[2];
    for (std::size_t i = 0; i < points; ++i) {
        const LeafExchange* like =
            leaves.is_known ? &leaves.solved[i] : nullptr;
        if (i == 1 && !like) like = &leaves.solved[0];
        leaves.solved[i] = air_.solve(leaves.points[i], like);
        found[i] = air_.fluxes_of(leaves.solved[i], leaves.points[i]);
    }
    if (points == 1) {
        leaves.solved[1] = leaves.solved[0];
        found[1] = found[0];
    }
    leaves.is_known = true;
    const std::size_t i = leaves.means[0].area > 0 ? 0 : 1;
    const LeafAir::Point& known = leaves.points[i];
    for (std::size_t k = 0; k < leaf_fluxes; ++k) {
        const bool by_gross = is_in_gross(static_cast<LeafFlux>(k));
        const double more = by_gross ? gross : light;
        leaves.slope[k] = std::abs(more) > least
                              ? (found[1][k].value - found[0][k].value) / more
                              : 0;
        leaves.constant[k] =
            found[i][k].value -
            leaves.slope[k] * (by_gross ? known.gross.value : known.ppfd);
    }
}

//! Returns the canopy air that follows from the fluxes of leaves in some air.
CanopyAir LeafLines::driven(const CanopyAir& in) {
    air_.set_air(in);
    CanopyAir sum;
    for (std::uint32_t c = 0; c < classes_.size(); ++c) {
        Class& leaves = classes_[c];
        if (!leaves.is_used) continue;
        draw(leaves);
        const Mean &shade = leaves.means[0], &sun = leaves.means[1];
        const auto flux = [&](LeafFlux of, double by) {
            const auto k = static_cast<std::size_t>(of);
            return leaves.constant[k] * (shade.area + sun.area) +
                   leaves.slope[k] * by;
        };
        const CanopyAir own =
            air_.driven_by(*air_.largest_of(c),
                           flux(LeafFlux::sensible, shade.ppfd + sun.ppfd),
                           flux(LeafFlux::transpiration, leaves.gross));
        sum.warmer += own.warmer;
        sum.moister += own.moister;
    }
    return sum;
}

//! Finds how the air that follows from the fluxes of leaves depends on the air
//! around the leaves, by a secant in each of its two numbers.
//! @param first air that follows from leaves in the air above the canopy
void LeafLines::find_slopes(const CanopyAir& first) {
    // Steps have about the size of the expected difference.
    const double dt = std::copysign(
        std::clamp(std::abs(first.warmer) / 2, 0.1, 2.), first.warmer);
    const double de = std::copysign(
        std::clamp(std::abs(first.moister) / 2, 0.02, 0.5), first.moister);
    const CanopyAir warm = driven({dt, 0}), moist = driven({0, de});
    slopes_ = {(warm.warmer - first.warmer) / dt,
               (moist.warmer - first.warmer) / de,
               (warm.moister - first.moister) / dt,
               (moist.moister - first.moister) / de};
}

//! Moves the air until it agrees with the air that follows from its leaves.
//! @param left remaining difference between both
void LeafLines::move_air(const CanopyAir& left) {
    const double a = slopes_[0] - 1, b = slopes_[1], c = slopes_[2],
                 d = slopes_[3] - 1;
    const double determinant = a * d - b * c;
    if (!(std::abs(determinant) > 1e-9)) return;
    constexpr double most_warmer = 8, most_moister = 2;
    const auto move = [](double& x, double by, double most) {
        x = std::clamp(x + by, -most, most);
    };
    move(in_.warmer, (b * left.moister - d * left.warmer) / determinant,
         most_warmer);
    move(in_.moister, (c * left.warmer - a * left.moister) / determinant,
         most_moister);
    driven_ = driven(in_);
}

void LeafLines::settle(const std::vector<LeafResponse>& responses) {
    find_points(responses);
    in_ = {};
    driven_ = driven(in_);
    if (driven_.warmer == 0 && driven_.moister == 0) return;
    find_slopes(driven_);
    move_air(driven_);
}

void LeafLines::correct(double heat, double water) {
    if (driven_.warmer == 0 && driven_.moister == 0) return;
    const auto any = std::ranges::find_if(
        classes_, [](const Class& each) { return each.is_used; });
    const auto c = static_cast<std::uint32_t>(any - classes_.begin());
    const CanopyAir more = air_.driven_by(*air_.largest_of(c), heat, water);
    move_air({driven_.warmer + more.warmer - in_.warmer,
              driven_.moister + more.moister - in_.moister});
}

double LeafLines::at(LeafFlux flux, std::uint32_t group,
                     const LeafAir::Point& point) const {
    if (flux == LeafFlux::hot)
        return at(LeafFlux::warming, group, point) > air_.hot_over_air(group)
                   ? 1
                   : 0;
    const auto [constant, slope] = line(flux, group);
    return constant +
           slope * (is_in_gross(flux) ? point.gross.value : point.ppfd);
}

}  // namespace ideotype
