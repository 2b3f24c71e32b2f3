// SPDX-License-Identifier: Apache-2.0
#include "ideotype/physiology/leaf_exchange.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

#include "ideotype/core/contract.hpp"
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

//! A table of values that depend on temperature only, with linear
//! interpolation; relative errors are below 1e-5.
template <class Factors>
class ByTemperature {
  public:
    struct Numbers {
        explicit Numbers(double temperature)
            : factors(temperature), saturated(saturated_vapour(temperature)) {}

        Factors factors;
        double saturated;  //!< saturation vapour pressure [kPa]
    };

    Numbers operator()(double temperature) const {
        const double place =
            (std::clamp(temperature, first, last) - first) / step;
        const auto below = static_cast<std::size_t>(place);
        const double part = place - static_cast<double>(below);
        Values result = values_[below];
        for (std::size_t i = 0; i < result.size(); ++i)
            result[i] += part * (values_[below + 1][i] - result[i]);
        return std::bit_cast<Numbers>(result);
    }

    static const ByTemperature& table() {
        static const ByTemperature made;
        return made;
    }

  private:
    using Values = std::array<double, sizeof(Numbers) / sizeof(double)>;
    static constexpr double first = -60, last = 60,
                            step = 0.1;  //!< range of the table [deg C]

    ByTemperature() {
        for (int i = 0; first + step * i < last + 2 * step; ++i)
            values_.push_back(std::bit_cast<Values>(Numbers(first + step * i)));
    }

    std::vector<Values> values_;
};

template <class Rates>
struct Model;

template <>
struct Model<CollatzLeaf> {
    using At = CollatzAt;
    using Factors = CollatzFactors;
};

template <>
struct Model<FarquharLeaf> {
    using At = FarquharAt;
    using Factors = FarquharFactors;
};

//! Returns the expansion of transpiration from that of net assimilation, to
//! which the opening of stomata is proportional to first order.
Expansion transpiration_of(double amount, double share, const Expansion& net) {
    if (!(net.value > 0)) return {amount, 0, 0};
    const double per_net = amount * share / net.value;
    return {amount, per_net * net.slope, per_net * net.curvature};
}

//! A leaf during the iteration of temperature, stomata and assimilation.
template <class Rates>
class Sweeps {
  public:
    Sweeps(const Rates& rates, const ThermalLeaf& leaf,
           const LeafSurroundings& around, const LeafExchange* like)
        : rates_(rates),
          stomata_(leaf.stomata),
          around_(around),
          energy_(leaf, around),
          t_(around.temperature),
          gs_(leaf.stomata.intercept) {
        if (!like) return;
        t_ += like->warmer;
        gs_ = like->conductance;
        net_ = like->net.value;
    }

    //! Iterates until the balance is reached; returns whether it was.
    bool settle() {
        constexpr int most = 20;
        constexpr double tolerance = 0.003;
        double before = 0, residual_before = 0;
        for (int i = 0; i < most; ++i) {
            breathe(2);
            const double residual = energy_.net_radiation(t_) -
                                    energy_.sensible(t_, heat_) - latent_;
            double slope = slope_of_residual();
            if (i > 0 && t_ != before)
                slope = std::min((residual - residual_before) / (t_ - before),
                                 slope / 2);
            before = t_;
            residual_before = residual;
            const double step = std::clamp(-residual / slope, -8., 8.);
            t_ += step;
            if (std::abs(step) < tolerance && is_steady_) {
                // Latent heat is set to close the balance exactly.
                latent_ =
                    energy_.net_radiation(t_) - energy_.sensible(t_, heat_);
                return has_one_balance();
            }
            if (t_ > warmest_of_one_balance + 8) return false;
        }
        return false;
    }

    LeafExchange result() const {
        Expansion net = response_.expand(around_.ppfd);
        net.value -= respiration_;
        const double amount = energy_.transpiration(latent_);
        const double share = gs_ > 0 && latent_ > 0
                                 ? boundary_ / (gs_ + boundary_) *
                                       (gs_ - stomata_.intercept) / gs_
                                 : 0;
        return {net,
                transpiration_of(amount, share, net),
                gs_,
                t_,
                energy_.sensible(t_, heat_),
                t_ - around_.temperature};
    }

  private:
    //! Computes assimilation and stomatal conductance at leaf temperature.
    void breathe(int passes) {
        const auto numbers = table_(t_);
        const typename Model<Rates>::At at(rates_, numbers.factors);
        heat_ = energy_.heat(t_);
        boundary_ = energy_.boundary_of(heat_);
        saturated_ = numbers.saturated;
        respiration_ = rates_.respiration * numbers.factors.respiration;
        const double vapour = energy_.vapour();
        for (int i = 0; i < passes; ++i) {
            const double surface =
                vapour +
                (saturated_ - vapour) * gs_ / std::max(gs_ + boundary_, 1e-12);
            const double slope = stomatal_slope(stomata_, saturated_, surface);
            const double cs = std::max(
                around_.co2 - 1.37 * std::max(net_, 0.) / boundary_, 1.);
            // The CO2 inside the leaf at which stomata are in balance with the
            // net rate.
            double ci = cs;
            gs_ = stomata_.intercept;
            if (net_ > 0 || i == 0) {
                const double open = std::max(net_, 0.) * slope / cs;
                gs_ += open;
                ci = net_ > 0 ? cs - 1.6 * net_ / gs_
                              : cs * (1 - 1.6 / std::max(slope, 1.61));
            } else {
                ci = cs - 1.6 * net_ / std::max(gs_, 1e-12);
            }
            response_ = at(std::max(ci, 0.));
            const double before = std::exchange(
                net_, response_.gross(around_.ppfd) - respiration_);
            is_steady_ = std::abs(net_ - before) < 1e-4 * (1 + std::abs(net_));
        }
        latent_ =
            saturated_ <= vapour
                ? energy_.latent_of(2 * vapour_over_heat * heat_, saturated_)
                : energy_.latent_of(gs_ * boundary_ / (gs_ + boundary_),
                                    saturated_);
    }

    bool has_one_balance() const {
        return t_ < warmest_of_one_balance &&
               (stomata_.model == Stomata::Model::medlyn ||
                energy_.vapour() >= least_humidity * saturated_);
    }

    //! Returns the slope of the residual in temperature, neglecting the
    //! response of stomata to temperature.
    double slope_of_residual() const {
        const double k = t_ + kelvin;
        const double total = saturated_ <= energy_.vapour()
                                 ? 2 * vapour_over_heat * heat_
                                 : gs_ * boundary_ / (gs_ + boundary_);
        const double rise = 4098 * saturated_ / ((t_ + 237.3) * (t_ + 237.3));
        return -(energy_.emission() * 4 * k * k * k +
                 2.5 * air_heat_capacity * heat_ +
                 energy_.latent_heat() * total * rise / around_.pressure);
    }

    const Rates& rates_;
    const ByTemperature<typename Model<Rates>::Factors>& table_ =
        ByTemperature<typename Model<Rates>::Factors>::table();
    const Stomata& stomata_;
    const LeafSurroundings& around_;
    LeafEnergy energy_;
    Colimitation response_{};
    double t_, gs_;
    bool is_steady_ = false;
    double net_ = 0, respiration_ = 0, heat_ = 0, boundary_ = 0, saturated_ = 0,
           latent_ = 0;
};

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
    const double share =
        found.conductance > 0 && found.latent > 0
            ? boundary / (found.conductance + boundary) *
                  (found.conductance - leaf.stomata.intercept) /
                  found.conductance
            : 0;
    return {net,
            transpiration_of(found.transpiration, share, net),
            found.conductance,
            found.temperature,
            found.sensible,
            found.temperature - around.temperature};
}

}  // namespace

LeafExchange leaf_exchange(const ThermalLeaf& leaf,
                           const LeafSurroundings& around,
                           const LeafExchange* like) {
    IDEOTYPE_EXPECT(around.width > 0 && around.pressure > 0);
    return std::visit(
        [&](const auto& rates) {
            if (around.wind >= least_wind &&
                around.temperature < warmest_of_one_balance) {
                Sweeps sweeps(rates, leaf, around, like);
                if (sweeps.settle()) return sweeps.result();
            }
            return from_balance(rates, leaf, around);
        },
        leaf.rates);
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
