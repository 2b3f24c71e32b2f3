// SPDX-License-Identifier: Apache-2.0
#include "ideotype/physiology/leaf_exchange.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/wide_vectors.hpp"
#include "lanes.hpp"
#include "leaf_energy.hpp"

namespace ideotype {

namespace {

//! The temperature up to which enzymes of all leaf models work, so that there
//! is a unique balance [deg C].
constexpr double warmest_of_one_balance = 38;
//! The humidity above which the Ball-Berry model gives a unique conductance.
constexpr double least_humidity = 0.35;
//! The wind above which leaf and air temperature differ little [m s-1].
constexpr double least_wind = 0.05;

//! The number of leaves in a batch.
constexpr std::size_t width = Lanes<double>::count;

// Functions that call another with each double of a value, for Lanes.

[[gnu::always_inline]] inline void for_each_double(CollatzLeaf& of,
                                                   const auto& take) {
    take(of.vmax), take(of.alpha), take(of.theta), take(of.beta), take(of.k),
        take(of.respiration);
}

[[gnu::always_inline]] inline void for_each_double(FarquharLeaf& of,
                                                   const auto& take) {
    take(of.vcmax), take(of.jmax), take(of.tpu), take(of.theta), take(of.beta),
        take(of.g1), take(of.respiration);
}

[[gnu::always_inline]] inline void for_each_double(CollatzFactors& of,
                                                   const auto& take) {
    take(of.capacity), take(of.co2), take(of.respiration);
}

[[gnu::always_inline]] inline void for_each_double(FarquharFactors& of,
                                                   const auto& take) {
    take(of.compensation), take(of.half_rate), take(of.vcmax), take(of.tpu),
        take(of.jmax), take(of.yield), take(of.rise), take(of.curvature),
        take(of.respiration);
}

[[gnu::always_inline]] inline void for_each_double(Colimitation& of,
                                                   const auto& take) {
    take(of.alpha), take(of.capacity), take(of.theta), take(of.beta),
        take(of.limit);
}

//! Values that depend on leaf temperature only.
template <class Factors>
struct NumbersAt {
    NumbersAt() = default;
    explicit NumbersAt(double temperature)
        : factors(temperature), saturated(saturated_vapour(temperature)) {}

    Factors factors;
    double saturated;  //!< saturation vapour pressure [kPa]
};

template <class Factors>
[[gnu::always_inline]] inline void for_each_double(NumbersAt<Factors>& of,
                                                   const auto& take) {
    for_each_double(of.factors, take);
    take(of.saturated);
}

//! A table of values that depend on temperature only, with linear
//! interpolation; relative errors are below 1e-5.
template <class Numbers>
class ByTemperature {
  public:
    [[gnu::always_inline]] Numbers operator()(double temperature) const {
        const double position =
            (std::min(std::max(temperature, first), last) - first) / step;
        const auto below = static_cast<int>(position);
        const double part = position - static_cast<double>(below);
        const double* const low = values_.data() + below * size;
        Numbers result;
        std::ptrdiff_t i = 0;
        for_each_double(result, [&](double& x) {
            x = low[i] + part * (low[i + size] - low[i]);
            ++i;
        });
        return result;
    }

    static const ByTemperature& table() {
        static const ByTemperature made;
        return made;
    }

  private:
    static constexpr std::ptrdiff_t size = sizeof(Numbers) / sizeof(double);
    static constexpr double first = -60, last = 60,
                            step = 0.1;  //!< range of the table [deg C]

    ByTemperature() {
        for (int i = 0; first + step * i < last + 2 * step; ++i) {
            Numbers row(first + step * i);
            for_each_double(row, [&](double& x) { values_.push_back(x); });
        }
    }

    std::vector<double> values_;  //!< rows by temperature
};

template <class Rates>
struct Model;

template <>
struct Model<CollatzLeaf> {
    using At = CollatzAt;
    using Numbers = NumbersAt<CollatzFactors>;
};

template <>
struct Model<FarquharLeaf> {
    using At = FarquharAt;
    using Numbers = NumbersAt<FarquharFactors>;
};

//! Returns the expansion of transpiration from that of net assimilation, to
//! which the opening of stomata is proportional to first order.
Expansion transpiration_of(double amount, double share, const Expansion& net) {
    if (!(net.value > 0)) return {amount, 0, 0};
    const double per_net = amount * share / net.value;
    return {amount, per_net * net.slope, per_net * net.curvature};
}

//! Returns the share of transpiration that follows from stomata opened by
//! assimilation.
//! @param latent latent heat flux; below 0: dew
double opened_share(double conductance, double intercept, double boundary,
                    double latent) {
    return conductance > 0 && latent > 0
               ? boundary / (conductance + boundary) *
                     (conductance - intercept) / conductance
               : 0;
}

//! The parts of a leaf and its surroundings that sweeps need.
template <class Rates>
struct SweptLeaf {
    SweptLeaf() = default;
    SweptLeaf(const Rates& of, const ThermalLeaf& leaf,
              const LeafSurroundings& around)
        : rates(of),
          energy(leaf, around),
          is_medlyn(leaf.stomata.model == Stomata::Model::medlyn ? 1 : 0),
          intercept(leaf.stomata.intercept),
          stomatal_slope(leaf.stomata.slope),
          opening(leaf.stomata.opening),
          ppfd(around.ppfd),
          co2(around.co2) {}

    Stomata stomata() const {
        return {
            is_medlyn > 0 ? Stomata::Model::medlyn : Stomata::Model::ball_berry,
            intercept, stomatal_slope, opening};
    }

    Rates rates;
    LeafEnergy energy;
    double is_medlyn, intercept, stomatal_slope, opening;
    double ppfd, co2;
};

//! The state of a leaf between two sweeps.
struct Swept {
    double t, gs, net;               //!< temperature, conductance, assimilation
    double before, residual_before;  //!< temperature of the sweep before
    double is_first;                 //!< 1 until the first sweep has ended
    double is_steady;                //!< 1 at the end
    Colimitation response;
    double respiration, heat, boundary, saturated, latent;
};

template <class Rates>
[[gnu::always_inline]] inline void for_each_double(SweptLeaf<Rates>& of,
                                                   const auto& take) {
    for_each_double(of.rates, take);
    of.energy.for_each_double(take);
    take(of.is_medlyn), take(of.intercept), take(of.stomatal_slope),
        take(of.opening), take(of.ppfd), take(of.co2);
}

[[gnu::always_inline]] inline void for_each_double(Swept& of,
                                                   const auto& take) {
    take(of.t), take(of.gs), take(of.net), take(of.before),
        take(of.residual_before), take(of.is_first), take(of.is_steady);
    for_each_double(of.response, take);
    take(of.respiration), take(of.heat), take(of.boundary), take(of.saturated),
        take(of.latent);
}

//! Computes assimilation and stomatal conductance at leaf temperature.
//! @param start above 0: a leaf that does not assimilate yet has the CO2 inside
//! that the slope of its stomata implies
//! @return change of net assimilation beyond its tolerance; below 0: steady
template <class Rates>
[[gnu::always_inline]] inline double breathe(
    const SweptLeaf<Rates>& leaf, const typename Model<Rates>::At& at,
    double start, Swept& now) {
    const double vapour = leaf.energy.vapour();
    const double surface = vapour + (now.saturated - vapour) * now.gs /
                                        std::max(now.gs + now.boundary, 1e-12);
    const double slope = stomatal_slope(leaf.stomata(), now.saturated, surface);
    const double taken = std::max(now.net, 0.);
    const double cs = std::max(leaf.co2 - 1.37 * taken / now.boundary, 1.);
    now.gs = leaf.intercept + taken * slope / cs;
    // The CO2 inside the leaf at which stomata are in balance with the net
    // rate.
    const double through = cs - 1.6 * now.net / std::max(now.gs, 1e-12);
    const double implied = cs * (1 - 1.6 / std::max(slope, 1.61));
    const double ci = now.net > 0 || !(start > 0) ? through : implied;
    now.response = at(std::max(ci, 0.));
    const double before = now.net;
    now.net = now.response.gross(leaf.ppfd) - now.respiration;
    return std::abs(now.net - before) - 1e-4 * (1 + std::abs(now.net));
}

//! Returns the slope of the residual of the energy balance in temperature,
//! neglecting the response of stomata to temperature.
[[gnu::always_inline]] inline double slope_of_residual(const LeafEnergy& energy,
                                                       const Swept& now) {
    const double k = now.t + kelvin;
    const double total = now.saturated <= energy.vapour()
                             ? 2 * vapour_over_heat * now.heat
                             : now.gs * now.boundary / (now.gs + now.boundary);
    const double rise =
        4098 * now.saturated / ((now.t + 237.3) * (now.t + 237.3));
    return -(energy.emission() * 4 * k * k * k +
             2.5 * air_heat_capacity * now.heat +
             energy.latent_heat() * total * rise / energy.pressure());
}

//! Updates stomata and assimilation at the temperature of a leaf, then its
//! temperature.
template <class Rates>
[[gnu::always_inline]] inline Swept sweep(
    const SweptLeaf<Rates>& leaf, Swept now,
    const typename Model<Rates>::Numbers& numbers) {
    constexpr double tolerance = 0.003;
    const LeafEnergy& energy = leaf.energy;
    // Assimilation and conductance.
    const typename Model<Rates>::At at(leaf.rates, numbers.factors);
    now.heat = energy.heat(now.t);
    now.boundary = energy.boundary_of(now.heat);
    now.saturated = numbers.saturated;
    now.respiration = leaf.rates.respiration * numbers.factors.respiration;
    breathe<Rates>(leaf, at, now.is_first, now);
    const double change = breathe<Rates>(leaf, at, 0, now);
    const double open = now.gs * now.boundary / (now.gs + now.boundary);
    now.latent = energy.latent_of(now.saturated <= energy.vapour()
                                      ? 2 * vapour_over_heat * now.heat
                                      : open,
                                  now.saturated);
    // A step of the secant method, which begins as one of Newton's.
    const double residual = energy.net_radiation(now.t) -
                            energy.sensible(now.t, now.heat) - now.latent;
    const double newton = slope_of_residual(energy, now);
    const double moved = now.t - now.before;
    const double secant =
        std::min((residual - now.residual_before) / (moved != 0 ? moved : 1),
                 newton / 2);
    const double next = moved != 0 ? secant : newton;
    const double slope = now.is_first > 0 ? newton : next;
    const double step = std::min(std::max(-residual / slope, -8.), 8.);
    now.before = now.t;
    now.residual_before = residual;
    now.is_first = 0;
    now.t += step;
    now.is_steady = std::max(std::abs(step) - tolerance, change) < 0 ? 1. : 0.;
    return now;
}

//! The largest number of sweeps.
constexpr int most_sweeps = 20;

//! Sweeps all leaves until they are steady.
template <class Rates>
[[gnu::always_inline]] inline void sweep_all(
    const Lanes<SweptLeaf<Rates>>& leaf,
    const ByTemperature<typename Model<Rates>::Numbers>& table,
    Lanes<Swept>& state) {
    using Numbers = typename Model<Rates>::Numbers;
    Lanes<Swept> here = state;
    for (int i = 0; i < most_sweeps; ++i) {
        Lanes<Numbers> numbers;
        for (std::size_t k = 0; k < width; ++k)
            numbers.set(k, table(here[k].t));
        double steady = 0;
        for (std::size_t k = 0; k < width; ++k) {
            const Swept now = here[k];
            here.set_unless(now.is_steady > 0, k,
                            sweep<Rates>(leaf[k], now, numbers[k]));
        }
        for (std::size_t k = 0; k < width; ++k) steady += here[k].is_steady;
        if (steady == width) break;
    }
    state = here;
}

IDEOTYPE_FOR_WIDE_VECTORS void sweep_leaves(
    const Lanes<SweptLeaf<CollatzLeaf>>& leaf,
    const ByTemperature<NumbersAt<CollatzFactors>>& table,
    Lanes<Swept>& state) {
    sweep_all<CollatzLeaf>(leaf, table, state);
}

IDEOTYPE_FOR_WIDE_VECTORS void sweep_leaves(
    const Lanes<SweptLeaf<FarquharLeaf>>& leaf,
    const ByTemperature<NumbersAt<FarquharFactors>>& table,
    Lanes<Swept>& state) {
    sweep_all<FarquharLeaf>(leaf, table, state);
}

//! Returns the exchange of a leaf from its last sweep.
template <class Rates>
LeafExchange result_of(const SweptLeaf<Rates>& leaf, const Swept& last) {
    const LeafEnergy& energy = leaf.energy;
    // Latent heat closes the balance exactly.
    const double sensible = energy.sensible(last.t, last.heat);
    const double latent = energy.net_radiation(last.t) - sensible;
    Expansion net = last.response.expand(leaf.ppfd);
    net.value -= last.respiration;
    const double share =
        opened_share(last.gs, leaf.intercept, last.boundary, latent);
    return {
        net,      transpiration_of(energy.transpiration(latent), share, net),
        last.gs,  last.t,
        sensible, last.t - energy.air()};
}

//! Returns the result of energy_balance() with derivatives.
template <class Rates>
LeafExchange from_balance(const Rates& rates, const ThermalLeaf& leaf,
                          const LeafSurroundings& around) {
    const EnergyBalance found = energy_balance(leaf, around);
    Expansion net =
        typename Model<Rates>::At(rates, found.temperature)(found.ci).expand(
            around.ppfd);
    net.value = found.net;
    const double boundary =
        LeafEnergy(leaf, around).boundary_of(found.boundary_heat);
    const double share = opened_share(found.conductance, leaf.stomata.intercept,
                                      boundary, found.latent);
    return {net,
            transpiration_of(found.transpiration, share, net),
            found.conductance,
            found.temperature,
            found.sensible,
            found.temperature - around.temperature};
}

//! Solves points whose leaves have the given model.
template <class Rates>
class Solver {
  public:
    Solver(std::span<const ThermalPoint> points, LeafExchange* results)
        : points_(points), results_(results) {}

    void solve() {
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const auto* rates = std::get_if<Rates>(&points_[i].leaf->rates);
            if (!rates) continue;
            const LeafSurroundings& around = points_[i].around;
            IDEOTYPE_EXPECT(around.width > 0 && around.pressure > 0);
            if (around.wind >= least_wind &&
                around.temperature < warmest_of_one_balance)
                add(i, *rates);
            else
                results_[i] = from_balance(*rates, *points_[i].leaf, around);
        }
        if (count_ > 0) sweep_lanes();
    }

  private:
    void add(std::size_t i, const Rates& rates) {
        const auto& [leaf, around, like] = points_[i];
        const SweptLeaf<Rates> swept(rates, *leaf, around);
        Swept start{};
        start.t = around.temperature + (like ? like->warmer : 0);
        start.gs = like ? like->conductance : leaf->stomata.intercept;
        start.net = like ? like->net.value : 0;
        start.is_first = 1;
        // Lanes without a leaf repeat the first.
        for (std::size_t k = count_; k < (count_ > 0 ? count_ + 1 : width);
             ++k) {
            leaves_.set(k, swept);
            state_.set(k, start);
        }
        lane_[count_++] = i;
        if (count_ == width) sweep_lanes();
    }

    void sweep_lanes() {
        sweep_leaves(leaves_,
                     ByTemperature<typename Model<Rates>::Numbers>::table(),
                     state_);
        for (std::size_t k = 0; k < count_; ++k) {
            const ThermalPoint& point = points_[lane_[k]];
            const SweptLeaf<Rates> leaf = leaves_[k];
            const Swept last = state_[k];
            const bool has_one_balance =
                last.is_steady > 0 && last.t < warmest_of_one_balance &&
                (leaf.is_medlyn > 0 ||
                 leaf.energy.vapour() >= least_humidity * last.saturated);
            results_[lane_[k]] =
                has_one_balance
                    ? result_of(leaf, last)
                    : from_balance(leaf.rates, *point.leaf, point.around);
        }
        count_ = 0;
    }

    std::span<const ThermalPoint> points_;
    LeafExchange* results_;
    Lanes<SweptLeaf<Rates>> leaves_;
    Lanes<Swept> state_;
    std::array<std::size_t, width> lane_{};  //!< number of the point by lane
    std::size_t count_ = 0;                  //!< lanes with a point
};

}  // namespace

void leaf_exchange(std::span<const ThermalPoint> points,
                   LeafExchange* results) {
    Solver<CollatzLeaf>(points, results).solve();
    Solver<FarquharLeaf>(points, results).solve();
}

LeafExchange exchange_at_air_temperature(const Stomata& stomata,
                                         const LeafSurroundings& around,
                                         const Expansion& net) {
    const double saturated = saturated_vapour(around.temperature);
    const double vapour = around.humidity * saturated;
    const double open = stomatal_slope(stomata, saturated, vapour) / around.co2;
    const double gs = stomata.intercept + open * std::max(net.value, 0.);
    const double amount = 1e3 * gs * (saturated - vapour) / around.pressure;
    const double share = gs > 0 ? (gs - stomata.intercept) / gs : 0;
    return {net, transpiration_of(amount, share, net),
            gs,  around.temperature,
            0,   0};
}

}  // namespace ideotype
