// SPDX-License-Identifier: Apache-2.0
#include "ideotype/physiology/energy_balance.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ideotype/core/contract.hpp"
#include "ideotype/physiology/temperature.hpp"
#include "leaf_energy.hpp"
#include "root.hpp"

namespace ideotype {

namespace {

//! A leaf at a given temperature with its boundary layer. The openness of its
//! stomata is gs / (gs + gb), from 0 to 1: the vapour pressure difference
//! across the boundary layer divided by the total difference between leaf and
//! air.
template <class AtTemperature>
class Behind {
  public:
    template <class Rates>
    Behind(const Rates& rates, const Stomata& stomata, const SurfaceAir& air,
           double absorbed, double temperature)
        : response_(rates, temperature),
          respiration_(dark_respiration(rates, temperature)),
          saturated_(saturated_vapour(temperature)),
          stomata_(stomata),
          air_(air),
          absorbed_(absorbed) {}

    //! Returns the balance of CO2. It is unique because more assimilation
    //! lowers the CO2 inside the leaf.
    LeafBalance at(double openness) const {
        const double gs = conductance(openness);
        const double resistance = resistance_of(gs);
        const double most = air_.co2 / resistance;
        const auto missing = [&](double a) {
            return a - net(std::max(air_.co2 - a * resistance, 0.));
        };
        const double a = root(missing, -respiration_, most, 1e-13);
        LeafBalance found{a, std::max(air_.co2 - a * resistance, 0.),
                          stomata_.intercept};
        if (a > 0)
            found.conductance +=
                slope(openness) * a / (air_.co2 - 1.37 * a / air_.boundary);
        return found;
    }

    //! Returns assimilation minus the assimilation for which stomata would have
    //! the given openness. It is positive, also below the intercept, if stomata
    //! would open further, and negative if they would close.
    double excess(double openness) const {
        const double gs = conductance(openness);
        const double beyond = gs - stomata_.intercept;
        if (beyond < 0) return 1;
        const double implied =
            air_.co2 / (slope(openness) / beyond + 1.37 / air_.boundary);
        return net(std::max(air_.co2 - implied * resistance_of(gs), 0.)) -
               implied;
    }

  private:
    double net(double ci) const {
        return response_(ci).gross(absorbed_) - respiration_;
    }

    //! Returns the stomatal conductance. Its lower bound is so small that it
    //! only prevents overflow.
    double conductance(double openness) const {
        return std::max(
            air_.boundary * openness / std::max(1 - openness, 1e-15), 1e-12);
    }

    //! Returns the resistance to CO2 from the air to the inside of the leaf [m2
    //! s mol-1].
    double resistance_of(double gs) const {
        return 1.37 / air_.boundary + 1.6 / gs;
    }

    //! Returns stomatal_slope(), with a lower bound above 0.
    double slope(double openness) const {
        return std::max(
            stomatal_slope(stomata_, saturated_,
                           std::lerp(air_.vapour, saturated_, openness)),
            1e-100);
    }

    AtTemperature response_;
    double respiration_, saturated_;
    const Stomata& stomata_;
    const SurfaceAir& air_;
    double absorbed_;
};

Behind<CollatzAt> behind(const CollatzLeaf& rates, const auto&... rest) {
    return {rates, rest...};
}

Behind<FarquharAt> behind(const FarquharLeaf& rates, const auto&... rest) {
    return {rates, rest...};
}

//! The first root of a function, and the number of its sign changes over
//! ordered points. The function counts as negative at the first point and
//! positive at the last.
struct FirstRoot {
    double x;
    int roots;
};

template <class Function, class Places>
FirstRoot first_root(const Function& f, const Places& places,
                     double tolerance) {
    Point before{places.front(), -1};
    FirstRoot found{places.back(), 0};
    for (std::size_t i = 1; i < places.size(); ++i) {
        const bool is_last = i + 1 == places.size();
        if (places[i] == before.x && !is_last) continue;
        const double value = f(places[i]);
        const Point here{places[i], is_last ? std::max(value, 0.) : value};
        if ((here.value < 0) != (before.value < 0) && ++found.roots == 1)
            found.x = root(f, before, here, tolerance);
        before = here;
    }
    return found;
}

constexpr std::size_t steps = 40;

template <class Rates>
LeafBalance balance_of(const Rates& rates, const Stomata& stomata,
                       const SurfaceAir& air, double absorbed,
                       double temperature) {
    const auto leaf = behind(rates, stomata, air, absorbed, temperature);
    std::array<double, steps + 1> closed;
    for (std::size_t i = 0; i <= steps; ++i)
        closed[i] = static_cast<double>(i) / steps;
    // Closed stomata are in balance if they would not open.
    const FirstRoot found =
        first_root([&](double x) { return leaf.excess(1 - x); }, closed, 1e-15);
    const double openness = 1 - found.x;
    LeafBalance result = leaf.at(openness);
    result.roots = found.roots;
    return result;
}

//! Returns temperatures between two limits. They are denser below the air
//! temperature, where conductances change rapidly in still air.
std::array<double, 2 * steps + 1> temperatures(double low, double high,
                                               double air) {
    const double bend = std::clamp(air, low, high);
    std::array<double, 2 * steps + 1> all;
    for (std::size_t i = 0; i <= steps; ++i) {
        const double part = static_cast<double>(i) / steps;
        all[i] = bend - (bend - low) * (1 - part) * (1 - part);
        all[steps + i] = bend + (high - bend) * part;
    }
    return all;
}

template <class Rates>
EnergyBalance energy_of(const Rates& rates, const ThermalLeaf& leaf,
                        const LeafSurroundings& around) {
    const LeafEnergy energy(leaf, around);
    const auto air_at = [&](double t) {
        return SurfaceAir{around.co2, energy.vapour(), energy.boundary(t)};
    };
    LeafBalance inside;
    double latent = 0, t = energy.warmest();
    if (energy.has_dew(t)) {
        inside = balance_of(rates, leaf.stomata, air_at(t), around.ppfd, t);
        latent = energy.latent_of_dew(t);
    } else {
        const auto excess = [&](double x) {
            const double openness = energy.openness(x);
            if (openness >= 1) return -openness;
            const SurfaceAir air = air_at(x);
            return behind(rates, leaf.stomata, air, around.ppfd, x)
                .excess(openness);
        };
        const double low = std::min(energy.coolest(), t);
        const FirstRoot found =
            first_root(excess, temperatures(low, t, around.temperature), 1e-12);
        t = found.x;
        const SurfaceAir air = air_at(t);
        inside = behind(rates, leaf.stomata, air, around.ppfd, t)
                     .at(std::min(energy.openness(t), 1.));
        inside.roots = found.roots;
        const double gs = inside.conductance;
        latent = energy.latent(t, gs * air.boundary / (gs + air.boundary));
    }
    return {t,
            inside.net,
            inside.conductance,
            inside.ci,
            energy.transpiration(latent),
            latent,
            energy.sensible(t),
            energy.net_radiation(t),
            energy.heat(t),
            inside.roots};
}

}  // namespace

Stomata closed(Stomata stomata, double opening) {
    IDEOTYPE_EXPECT(opening >= 0 && opening <= 1);
    stomata.intercept *= opening;
    stomata.opening *= opening;
    return stomata;
}

LeafBalance balance(const Co2Leaf& leaf, const Stomata& stomata,
                    const SurfaceAir& air, double absorbed,
                    double temperature) {
    IDEOTYPE_EXPECT(air.boundary > 0 && air.co2 >= 0);
    return std::visit(
        [&](const auto& each) {
            return balance_of(each, stomata, air, absorbed, temperature);
        },
        leaf);
}

EnergyBalance energy_balance(const ThermalLeaf& leaf,
                             const LeafSurroundings& around) {
    IDEOTYPE_EXPECT(around.width > 0 && around.pressure > 0);
    return std::visit(
        [&](const auto& each) { return energy_of(each, leaf, around); },
        leaf.rates);
}

}  // namespace ideotype
