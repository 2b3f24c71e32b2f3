// SPDX-License-Identifier: Apache-2.0
#include "leaf_lines.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ideotype {

namespace {

//! The difference of light or assimilation [umol m-2 s-1] below which leaves of
//! a class count as equal.
constexpr double least_difference = 0.1;

}  // namespace

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
    find_members();
}

//! Finds the classes with leaves, and a middle class of each component to
//! represent all its classes.
void LeafLines::find_members() {
    constexpr std::uint32_t per_component = LeafAir::classes_per_component;
    constexpr std::array<std::uint32_t, per_component> by_preference{2, 1, 3,
                                                                     0};
    all_.clear();
    typical_.clear();
    for (std::uint32_t first = 0; first < classes_.size();
         first += per_component) {
        double area = 0;
        for (std::uint32_t c = first; c < first + per_component; ++c) {
            if (!classes_[c].is_used) continue;
            area += classes_[c].area();
            all_.push_back({c, 1});
        }
        for (const std::uint32_t i : by_preference)
            if (area > 0 && classes_[first + i].is_used) {
                typical_.push_back(
                    {first + i, area / classes_[first + i].area()});
                break;
            }
    }
}

//! Returns the number of mean leaves of a class to be solved. The slope between
//! two nearly identical leaves would consist mostly of rounding errors.
std::size_t LeafLines::points_of(const Class& leaves) const {
    const auto& [shade, sun] = leaves.points;
    return std::max(std::abs(sun.ppfd - shade.ppfd),
                    std::abs(sun.gross.value - shade.gross.value)) >
                   least_difference
               ? 2
               : 1;
}

//! Computes the lines of a class from the solutions of its mean leaves.
void LeafLines::draw(Class& leaves) {
    const auto& [shade, sun] = leaves.points;
    const double light = sun.ppfd - shade.ppfd;
    const double gross = sun.gross.value - shade.gross.value;
    const std::size_t i = leaves.means[0].area > 0 ? 0 : 1;
    LeafAir::Fluxes found[2];
    found[i] = air_.fluxes_of(leaves.solved[i], leaves.points[i]);
    // Without another leaf all slopes are 0.
    if (points_of(leaves) == 2)
        found[1 - i] =
            air_.fluxes_of(leaves.solved[1 - i], leaves.points[1 - i]);
    const LeafAir::Point& known = leaves.points[i];
    for (std::size_t k = 0; k < leaf_fluxes; ++k) {
        const bool by_gross = is_in_gross(static_cast<LeafFlux>(k));
        const double more = by_gross ? gross : light;
        leaves.slope[k] = std::abs(more) > least_difference
                              ? (found[1][k].value - found[0][k].value) / more
                              : 0;
        leaves.constant[k] =
            found[i][k].value -
            leaves.slope[k] * (by_gross ? known.gross.value : known.ppfd);
    }
}

//! Returns the canopy air that results from the lines of a class.
CanopyAir LeafLines::driven_by(std::uint32_t c) const {
    const Class& leaves = classes_[c];
    const Mean &shade = leaves.means[0], &sun = leaves.means[1];
    const auto flux = [&](LeafFlux of, double by) {
        const auto k = static_cast<std::size_t>(of);
        return leaves.constant[k] * leaves.area() + leaves.slope[k] * by;
    };
    return air_.driven_by(*air_.largest_of(c),
                          flux(LeafFlux::sensible, shade.ppfd + sun.ppfd),
                          flux(LeafFlux::transpiration, leaves.gross));
}

//! Computes the lines of some classes in several states of the canopy air, and
//! the canopy air that results from each. The lines of the last state stay.
void LeafLines::drive(const std::vector<Member>& members,
                      std::span<const CanopyAir> airs, CanopyAir* driven) {
    // Solve the mean leaves of all classes in all airs together.
    batch_.clear();
    for (const CanopyAir& air : airs) {
        air_.set_air(air);
        for (const Member& member : members) {
            const Class& leaves = classes_[member.number];
            for (std::size_t i = 0; i < points_of(leaves); ++i)
                batch_.add(leaves.points[i],
                           leaves.is_known ? &leaves.solved[i] : nullptr);
        }
    }
    const LeafExchange* next = batch_.solve().data();
    for (std::size_t a = 0; a < airs.size(); ++a) {
        driven[a] = {};
        for (const Member& member : members) {
            Class& leaves = classes_[member.number];
            const std::size_t points = points_of(leaves);
            leaves.solved[0] = next[0];
            leaves.solved[1] = next[points - 1];
            leaves.is_known = true;
            next += points;
            draw(leaves);
            const CanopyAir own = driven_by(member.number);
            driven[a].warmer += member.scale * own.warmer;
            driven[a].moister += member.scale * own.moister;
        }
    }
}

//! Returns the canopy air that results from the fluxes of leaves in given air.
CanopyAir LeafLines::driven(const CanopyAir& in) {
    CanopyAir result;
    drive(all_, {&in, 1}, &result);
    return result;
}

//! Estimates the canopy air from the typical classes. Also estimates the
//! derivatives of the resulting air with respect to the air around the leaves,
//! by one secant for each of its two variables.
void LeafLines::guess_air() {
    in_ = {};
    if (!air_.has_canopy_air()) return;
    constexpr double dt = 0.5, de = 0.05;  // steps of the secants [K, kPa]
    constexpr std::array<CanopyAir, 3> airs{CanopyAir{}, {dt, 0}, {0, de}};
    std::array<CanopyAir, airs.size()> by;
    drive(typical_, airs, by.data());
    const auto& [first, warm, moist] = by;
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
        const auto point = [&](const Stratum& of) {
            return LeafAir::Point{air_.mean_place(of.number), of.ppfd,
                                  of.cosine};
        };
        batch_.clear();
        for (std::size_t i = 0; i < strata.size(); ++i)
            batch_.add(point(strata[i]), is_known ? &solved[i] : nullptr);
        std::ranges::copy(batch_.solve(), solved.begin());
        for (std::size_t i = 0; i < strata.size(); ++i) {
            const Stratum& each = strata[i];
            const LeafAir::Fluxes found =
                air_.fluxes_of(solved[i], point(each));
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
