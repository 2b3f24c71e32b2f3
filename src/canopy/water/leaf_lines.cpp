// SPDX-License-Identifier: Apache-2.0
#include "leaf_lines.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ideotype {

void LeafLines::add(std::uint32_t group, double ppfd, double cosine,
                    double area) {
    // By rounding, the shaded area of a place may be slightly negative.
    if (!(area > 0)) return;
    Mean& mean = of(group).means[cosine > 0 ? 1 : 0];
    mean.area += area;
    mean.ppfd += area * ppfd;
    mean.cosine += area * cosine;
}

//! Computes the mean leaves of classes. If a class has no leaves in the sun or
//! in the shade, a leaf in the dark is used.
void LeafLines::find_points(const std::vector<LeafResponse>& responses) {
    for (std::uint32_t c = 0; c < classes_.size(); ++c) {
        Class& leaves = classes_[c];
        const auto group = air_.largest_of(c);
        leaves.is_used = group && leaves.area() > 0;
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
    find_typical();
}

//! Chooses a middle class of each component to represent all its classes.
void LeafLines::find_typical() {
    constexpr std::uint32_t all = LeafAir::classes_per_component;
    constexpr std::array<std::uint32_t, all> by_preference{2, 1, 3, 0};
    typical_.clear();
    for (std::uint32_t first = 0; first < classes_.size(); first += all) {
        double area = 0;
        for (std::uint32_t c = first; c < first + all; ++c)
            if (classes_[c].is_used) area += classes_[c].area();
        for (const std::uint32_t i : by_preference)
            if (area > 0 && classes_[first + i].is_used) {
                typical_.push_back(
                    {first + i, area / classes_[first + i].area()});
                break;
            }
    }
}

void LeafLines::draw(Class& leaves) {
    const auto& [shade, sun] = leaves.points;
    const double light = sun.ppfd - shade.ppfd;
    const double gross = sun.gross.value - shade.gross.value;
    // The slope between two nearly identical leaves would consist mostly of
    // rounding errors.
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

//! Computes the lines of a class, and returns the canopy air that results from
//! them.
CanopyAir LeafLines::driven_by(std::uint32_t c) {
    Class& leaves = classes_[c];
    draw(leaves);
    const Mean &shade = leaves.means[0], &sun = leaves.means[1];
    const auto flux = [&](LeafFlux of, double by) {
        const auto k = static_cast<std::size_t>(of);
        return leaves.constant[k] * leaves.area() + leaves.slope[k] * by;
    };
    return air_.driven_by(*air_.largest_of(c),
                          flux(LeafFlux::sensible, shade.ppfd + sun.ppfd),
                          flux(LeafFlux::transpiration, leaves.gross));
}

//! Returns the canopy air that results from the fluxes of leaves in given air.
CanopyAir LeafLines::driven(const CanopyAir& in) {
    air_.set_air(in);
    CanopyAir sum;
    for (std::uint32_t c = 0; c < classes_.size(); ++c) {
        if (!classes_[c].is_used) continue;
        const CanopyAir own = driven_by(c);
        sum.warmer += own.warmer;
        sum.moister += own.moister;
    }
    return sum;
}

//! Estimates driven() from the typical classes only.
CanopyAir LeafLines::typically_driven(const CanopyAir& in) {
    air_.set_air(in);
    CanopyAir sum;
    for (const Typical& each : typical_) {
        const CanopyAir own = driven_by(each.number);
        sum.warmer += each.scale * own.warmer;
        sum.moister += each.scale * own.moister;
    }
    return sum;
}

//! Estimates the canopy air from the typical classes. Also estimates the
//! derivatives of the resulting air with respect to the air around the leaves,
//! by one secant for each of its two variables.
void LeafLines::guess_air() {
    in_ = {};
    const CanopyAir first = typically_driven(in_);
    if (first.warmer == 0 && first.moister == 0) return;
    // The secant steps have about the size of the expected difference.
    const double dt = std::copysign(
        std::clamp(std::abs(first.warmer) / 2, 0.1, 2.), first.warmer);
    const double de = std::copysign(
        std::clamp(std::abs(first.moister) / 2, 0.02, 0.5), first.moister);
    const CanopyAir warm = typically_driven({dt, 0}),
                    moist = typically_driven({0, de});
    slopes_ = {(warm.warmer - first.warmer) / dt,
               (moist.warmer - first.warmer) / de,
               (warm.moister - first.moister) / dt,
               (moist.moister - first.moister) / de};
    move_air(first);
}

//! Moves the air towards agreement with the air that results from its leaves.
//! @param left resulting air minus the air in the step
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
}

//! Updates the derivatives from a move of the air (Broyden 1965,
//! doi:10.1090/S0025-5718-1965-0198670-6).
//! @param by move of the air
//! @param more resulting change of the air that follows from its leaves
void LeafLines::learn_slopes(const CanopyAir& by, const CanopyAir& more) {
    // A vapour pressure of 0.1 kPa gets the same weight as 1 K.
    constexpr double kelvin_per_kpa = 10;
    const double t = by.warmer,
                 e = kelvin_per_kpa * kelvin_per_kpa * by.moister;
    const double size = t * by.warmer + e * by.moister;
    if (!(size > 1e-6)) return;
    const double warmer =
        more.warmer - slopes_[0] * by.warmer - slopes_[1] * by.moister;
    const double moister =
        more.moister - slopes_[2] * by.warmer - slopes_[3] * by.moister;
    slopes_[0] += warmer * t / size;
    slopes_[1] += warmer * e / size;
    slopes_[2] += moister * t / size;
    slopes_[3] += moister * e / size;
}

void LeafLines::settle(const std::vector<LeafResponse>& responses) {
    find_points(responses);
    guess_air();
    driven_ = driven(in_);
}

void LeafLines::correct(double heat, double water) {
    if (driven_.warmer == 0 && driven_.moister == 0) return;
    const CanopyAir more =
        air_.driven_by(*air_.largest_of(typical_.front().number), heat, water);
    constexpr int most = 4;
    constexpr double warmer = 0.05, moister = 0.005;
    for (int i = 0; i < most; ++i) {
        const CanopyAir left{air_left().warmer + more.warmer,
                             air_left().moister + more.moister};
        if (std::abs(left.warmer) < warmer && std::abs(left.moister) < moister)
            return;
        const CanopyAir in = in_, before = driven_;
        move_air(left);
        driven_ = driven(in_);
        learn_slopes(
            {in_.warmer - in.warmer, in_.moister - in.moister},
            {driven_.warmer - before.warmer, driven_.moister - before.moister});
    }
}

std::vector<LeafLines::Sums> LeafLines::close_stomata(
    const std::vector<double>& openings, const std::vector<Stratum>& strata) {
    const CanopyAir in = in_;
    const auto slopes = slopes_;
    std::vector<LeafExchange> solved(strata.size());
    bool is_known = false;
    // The sums of fluxes in the air of the step, and the air that results.
    const auto sum_up = [&] {
        air_.set_air(in_);
        std::pair<Sums, CanopyAir> result{};
        auto& [sums, by] = result;
        for (std::size_t i = 0; i < strata.size(); ++i) {
            const Stratum& each = strata[i];
            const LeafAir::Point point{air_.mean_place(each.number), each.ppfd,
                                       each.cosine};
            solved[i] = air_.solve(point, is_known ? &solved[i] : nullptr);
            const LeafAir::Fluxes found = air_.fluxes_of(solved[i], point);
            for (std::size_t k = 0; k < leaf_fluxes; ++k)
                sums[k] += each.area * found[k].value;
            const auto amount = [&](LeafFlux flux) {
                return each.area * found[static_cast<std::size_t>(flux)].value;
            };
            const CanopyAir own = air_.driven_by(
                *air_.largest_of(each.number), amount(LeafFlux::sensible),
                amount(LeafFlux::transpiration));
            by.warmer += own.warmer;
            by.moister += own.moister;
        }
        is_known = true;
        return result;
    };
    const auto [open, typical] = sum_up();
    std::vector<Sums> all{open};
    // All leaves drive the air a little differently from these.
    const CanopyAir more{driven_.warmer - typical.warmer,
                         driven_.moister - typical.moister};
    for (const double opening : openings) {
        air_.close_stomata(opening);
        constexpr int most = 3;
        constexpr double warmer = 0.3, moister = 0.03;
        CanopyAir before, by_before;
        for (int i = 0; i < most; ++i) {
            const auto [sums, by] = sum_up();
            if (i == 0) all.emplace_back();
            all.back() = sums;
            if (i > 0)
                learn_slopes(
                    {in_.warmer - before.warmer, in_.moister - before.moister},
                    {by.warmer - by_before.warmer,
                     by.moister - by_before.moister});
            before = in_;
            by_before = by;
            const CanopyAir left{by.warmer + more.warmer - in_.warmer,
                                 by.moister + more.moister - in_.moister};
            // The last move is the start of the next opening.
            move_air(left);
            if (std::abs(left.warmer) < warmer &&
                std::abs(left.moister) < moister)
                break;
        }
    }
    in_ = in;
    slopes_ = slopes;
    air_.close_stomata(1);
    air_.set_air(in_);
    return all;
}

Expansion LeafLines::at(LeafFlux flux, std::uint32_t group,
                        const LeafAir::Point& point) const {
    if (flux == LeafFlux::hot) {
        const bool is_hot = at(LeafFlux::warming, group, point).value >
                            air_.hot_over_air(group);
        return {is_hot ? 1. : 0., 0, 0};
    }
    const auto [constant, slope] = line(flux, group);
    if (!is_in_gross(flux)) return {constant + slope * point.ppfd, slope, 0};
    return {constant + slope * point.gross.value, slope * point.gross.slope,
            slope * point.gross.curvature};
}

bool LeafLines::reaches_heat(double light) const {
    constexpr auto k = static_cast<std::size_t>(LeafFlux::warming);
    for (std::uint32_t c = 0; c < classes_.size(); ++c) {
        const Class& each = classes_[c];
        if (each.is_used &&
            each.constant[k] + std::max(each.slope[k], 0.) * light >
                air_.hot_over_air(*air_.largest_of(c)))
            return true;
    }
    return false;
}

}  // namespace ideotype
