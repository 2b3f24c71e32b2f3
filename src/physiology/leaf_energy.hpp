// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

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
    return stomata.opening < 1 && slope > 1.6
               ? 1.6 + stomata.opening * (slope - 1.6)
               : slope;
}

//! The energy balance of a point on a leaf at any temperature.
class LeafEnergy {
  public:
    LeafEnergy(const ThermalLeaf& leaf, const LeafSurroundings& around)
        : around_(around),
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
    //! Returns the latent heat of vaporisation [J mol-1].
    double latent_heat() const { return latent_heat_; }
    //! Returns the emission of both faces divided by the fourth power of
    //! temperature.
    double emission() const { return emission_; }

    //! Returns the boundary-layer conductance for heat of one face.
    double heat(double t) const {
        const double apart = std::abs(t - around_.temperature);
        return std::cbrt(unmoved_ + cube(free_ * std::sqrt(std::sqrt(apart))));
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
        return 2 * air_heat_capacity * of_heat * (t - around_.temperature);
    }

    //! Returns the latent heat flux at a conductance for vapour [W m-2].
    double latent(double t, double conductance) const {
        return latent_of(conductance, saturated_vapour(t));
    }

    //! @param saturated saturation vapour pressure at leaf temperature [kPa]
    double latent_of(double conductance, double saturated) const {
        return latent_heat_ * conductance * (saturated - vapour_) /
               around_.pressure;
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
        const double t = around_.temperature, alone = radiative();
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
            return 2 * air_heat_capacity * (x - around_.temperature) +
                   latent(x, vapour_over_heat * faces_);
        };
        return std::min(root(cooling, coldest, around_.temperature, 1e-9),
                        radiative());
    }

    //! Returns the stomatal openness that closes the energy balance. Values up
    //! to 2 mean that even stomata without resistance evaporate too little.
    double openness(double t) const {
        const double most = latent(t, boundary(t));
        const double need = net_radiation(t) - sensible(t);
        return most > 0 ? std::clamp(need / most, 0., 2.) : 2;
    }

  private:
    static double cube(double x) { return x * x * x; }

    double radiative() const {
        return std::max(std::sqrt(std::sqrt(absorbed_ / emission_)) - kelvin,
                        coldest);
    }

    const LeafSurroundings& around_;
    double absorbed_, emission_, vapour_, latent_heat_;
    double free_, unmoved_, faces_;
};

}  // namespace ideotype
