// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "ideotype/core/units.hpp"
#include "ideotype/physiology/energy_balance.hpp"
#include "ideotype/physiology/temperature.hpp"
#include "root.hpp"

namespace ideotype {

//! Lowest leaf temperature considered [deg C], above the pole of
//! saturated_vapour().
inline constexpr double coldest = -200;
inline constexpr double vapour_over_heat = 1.09;

//! Returns the stomatal conductance above the intercept, divided by
//! assimilation over surface CO2.
//! @param saturated,surface vapour pressure in the leaf and at its surface
//! [kPa]
inline double stomatal_slope(const Stomata& stomata, double saturated,
                             double surface) {
    if (stomata.model == Stomata::Model::medlyn)
        return 1.6 * (1 + stomata.opening * stomata.slope /
                              std::sqrt(std::max(saturated - surface, 0.05)));
    const double slope = stomata.slope * std::min(surface / saturated, 1.);
    return slope - (1 - stomata.opening) * std::max(slope - 1.6, 0.);
}

//! Returns the cube root of a finite number that is not negative, with a
//! relative error below 1e-15. Unlike std::cbrt(), it can be part of a loop
//! over arrays that becomes vectors. It begins with a third of the exponent,
//! which is within 6 %, and takes three steps of Halley's method, each of which
//! cubes the error.
inline double cube_root(double x) {
    // The upper half of the bits, which contains the exponent, becomes a number
    // and back without conversions, which few instruction sets have: 2^52 plus
    // an integer has the integer as its last bits. Two thirds of the bias of
    // the exponent are added to a third of the exponent.
    constexpr double shift = 0x1p52;
    const double upper =
        std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) >> 32 |
                              std::bit_cast<std::uint64_t>(shift)) -
        shift;
    double root = std::bit_cast<double>(
        std::bit_cast<std::uint64_t>(upper / 3 + 715094163 + shift) << 32);
    for (int i = 0; i < 3; ++i) {
        const double cube = root * root * root;
        root *= (cube + 2 * x) / (2 * cube + x);
    }
    return x > std::numeric_limits<double>::min() ? root : 0;
}

//! The energy balance of a point on a leaf at any temperature. All members are
//! doubles, so that Lanes can contain it.
class LeafEnergy {
  public:
    LeafEnergy() = default;
    LeafEnergy(const ThermalLeaf& leaf, const LeafSurroundings& around)
        : air_(around.temperature),
          pressure_(around.pressure),
          absorbed_(around.ppfd / mol_per_mj_par + around.nir +
                    around.longwave),
          emission_(2 * leaf.emissivity * stefan_boltzmann),
          vapour_(around.humidity * saturated_vapour(around.temperature)),
          latent_heat_(0.0180153 * (2.501e6 - 2361 * around.temperature)) {
        const double d = 0.72 * around.width;
        const double air =
            around.pressure / (gas_constant * (around.temperature + kelvin));
        free_ = 0.05 / std::sqrt(std::sqrt(d));
        unmoved_ = cube(1.4 * 0.135 * std::sqrt(around.wind / d)) +
                   cube(2.15e-5 * air / d);
        const double r = leaf.ratio > 1 ? 1 / leaf.ratio : leaf.ratio;
        faces_ = (1 + r) * (1 + r) / (1 + r * r);
    }

    double vapour() const { return vapour_; }
    //! Returns the temperature of the air [deg C].
    double air() const { return air_; }
    double pressure() const { return pressure_; }
    //! Returns the latent heat of vaporisation [J mol-1].
    double latent_heat() const { return latent_heat_; }
    //! Returns the emission of both faces divided by the fourth power of
    //! temperature.
    double emission() const { return emission_; }

    //! Returns the boundary-layer conductance for heat of one face.
    double heat(double t) const {
        const double apart = std::abs(t - air_);
        return cube_root(unmoved_ + cube(free_ * std::sqrt(std::sqrt(apart))));
    }

    //! Returns the boundary-layer conductance for vapour, combined over the
    //! faces with stomata.
    double boundary(double t) const { return boundary_of(heat(t)); }

    //! @param of_heat conductance for heat of one face
    double boundary_of(double of_heat) const {
        return vapour_over_heat * faces_ * of_heat;
    }

    double net_radiation(double t) const {
        const double k = t + kelvin;
        return absorbed_ - emission_ * k * k * k * k;
    }

    double sensible(double t) const { return sensible(t, heat(t)); }

    double sensible(double t, double of_heat) const {
        return 2 * air_heat_capacity * of_heat * (t - air_);
    }

    //! Returns the latent heat flux at a conductance for vapour [W m-2].
    double latent(double t, double conductance) const {
        return latent_of(conductance, saturated_vapour(t));
    }

    //! @param saturated saturation vapour pressure at leaf temperature [kPa]
    double latent_of(double conductance, double saturated) const {
        return latent_heat_ * conductance * (saturated - vapour_) / pressure_;
    }

    double latent_of_dew(double t) const {
        return std::min(latent(t, 2 * vapour_over_heat * heat(t)), 0.);
    }

    //! Returns whether the air is saturated at leaf temperature, so that no
    //! water leaves the leaf.
    bool has_dew(double t) const { return saturated_vapour(t) <= vapour_; }

    double transpiration(double latent) const {
        return 1e3 * latent / latent_heat_;
    }

    //! Returns the temperature with closed stomata, which no leaf exceeds. It
    //! is unique because net radiation minus all heat fluxes decreases with
    //! temperature.
    double warmest() const {
        const double t = air_, alone = radiative();
        return root(
            [&](double x) {
                return sensible(x) + latent_of_dew(x) - net_radiation(x);
            },
            std::min(t, alone), std::max(t, alone), 1e-12);
    }

    //! Returns a lower bound of the temperature of a leaf without dew: the
    //! smaller of the temperature of a wet surface without radiation, at any
    //! wind, and the temperature at radiative equilibrium. Below it both heat
    //! and radiation warm a leaf.
    double coolest() const {
        const auto cooling = [&](double x) {
            return 2 * air_heat_capacity * (x - air_) +
                   latent(x, vapour_over_heat * faces_);
        };
        return std::min(root(cooling, coldest, air_, 1e-9), radiative());
    }

    //! Returns the stomatal openness that closes the energy balance. Values up
    //! to 2 mean that even stomata without resistance evaporate too little.
    double openness(double t) const {
        const double most = latent(t, boundary(t));
        const double need = net_radiation(t) - sensible(t);
        return most > 0 ? std::clamp(need / most, 0., 2.) : 2;
    }

    //! Calls a function with each member.
    [[gnu::always_inline]] void for_each_double(const auto& take) {
        take(air_), take(pressure_), take(absorbed_), take(emission_),
            take(vapour_), take(latent_heat_), take(free_), take(unmoved_),
            take(faces_);
    }

  private:
    static double cube(double x) { return x * x * x; }

    double radiative() const {
        return std::max(std::sqrt(std::sqrt(absorbed_ / emission_)) - kelvin,
                        coldest);
    }

    double air_, pressure_;
    double absorbed_, emission_, vapour_, latent_heat_;
    double free_, unmoved_, faces_;
};

}  // namespace ideotype
