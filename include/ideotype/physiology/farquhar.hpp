// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/physiology/hyperbola.hpp"

namespace ideotype {

//! Rates of a C3 leaf at 25 deg C. Defaults are for soybean, as in BioCro.
struct FarquharLeaf {
    //! Rubisco capacity [umol m-2 s-1] (Bernacchi et al. 2005,
    //! doi:10.1007/s00425-004-1320-8, seasonal mean).
    double vcmax = 110;
    //! Capacity of electron transport [umol m-2 s-1] (same source), fitted with
    //! 4.5 electrons per carboxylation, see farquhar_at().
    double jmax = 195;
    //! Capacity of triose phosphate use [umol m-2 s-1] (BioCro).
    double tpu = 13;
    //! Curvature between light and jmax [-] (Bernacchi et al. 2003).
    double theta = 0.97875;
    //! Curvature between the three limits [-]: 0.98 (Collatz et al. 1991,
    //! doi:10.1016/0168-1923(91)90002-8, for Rubisco and light). With 1, the
    //! result is the smallest limit; with 0.98, two equal limits give 12 %
    //! less.
    double beta = 0.98;
    //! Stomatal slope [kPa^0.5]: 5.79 for C3 crops (Lin et al. 2015,
    //! doi:10.1038/nclimate2550).
    double g1 = 5.79;
    //! Respiration, equal in light and dark [umol m-2 s-1] (Davey et al. 2004,
    //! doi:10.1104/pp.103.030569).
    double respiration = 1.28;
};

//! Response to light at a temperature [deg C] (Farquhar, von Caemmerer and
//! Berry 1980, doi:10.1007/BF00386231). The response excludes the leaf's
//! respiration but includes photorespiration: net assimilation is gross() -
//! dark_respiration(). It is a smooth minimum of the limits by Rubisco,
//! electron transport and triose phosphate use,
//!
//!     Wc = Vcmax (ci - G*) / [ci + Kc (1 + O / Ko)]
//!     Wj = J (ci - G*) / (4.5 ci + 10.5 G*)
//!     Wp = 3 TPU
//!     theta J^2 - (I2 + Jmax) J + I2 Jmax = 0    (smaller root)
//!
//! with I2 = 0.5 phi(T) I and O = 0.21 mol mol-1 of oxygen; the response is 0
//! if ci is below G*. The minimum of Wc and Wp is computed first because both
//! are independent of light. Vcmax, G*, Kc, Ko (Bernacchi et al. 2001,
//! doi:10.1111/j.1365-3040.2001.00668.x) and Jmax (Bernacchi et al. 2003,
//! doi:10.1046/j.0016-8025.2003.01050.x) rise as exp(c - E / R T). phi and
//! theta are parabolas limited to 0 to 1, and 4.5 and 10.5 are electrons (all
//! 2003). TPU falls above 33 deg C (Harley et al. 1992, as in Sharkey et al.
//! 2007, doi:10.1111/j.1365-3040.2007.01710.x). The responses were measured
//! from 10 to 40 deg C; Vcmax and Jmax do not fall in heat.
//! @param ci CO2 inside the leaf [umol mol-1]
Colimitation farquhar_at(const FarquharLeaf& leaf, double temperature,
                         double ci);

//! Factors of the rates of a C3 leaf at a temperature, relative to 25 deg C
//! unless a unit is given.
struct FarquharFactors {
    FarquharFactors() = default;
    explicit FarquharFactors(double temperature);

    double compensation;  //!< G* [umol mol-1]
    double half_rate;     //!< Kc (1 + O / Ko) [umol mol-1]
    double vcmax, tpu, jmax;
    double yield;            //!< electrons per absorbed photon [-]
    double rise, curvature;  //!< added to and subtracted from theta [-]
    double respiration;      //!< temperature response of respiration
};

//! Like farquhar_at(), but faster for many values of CO2.
class FarquharAt {
  public:
    FarquharAt(const FarquharLeaf& leaf, double temperature)
        : FarquharAt(leaf, FarquharFactors(temperature)) {}
    FarquharAt(const FarquharLeaf& leaf, const FarquharFactors& factors)
        : compensation_(factors.compensation),
          half_rate_(factors.half_rate),
          vcmax_(leaf.vcmax * factors.vcmax),
          triose_use_(3 * leaf.tpu * factors.tpu),
          jmax_(leaf.jmax),
          jmax_rise_(factors.jmax),
          yield_(factors.yield),
          theta_(std::min(
              std::max(leaf.theta + factors.rise - factors.curvature, 0.), 1.)),
          beta_(leaf.beta) {}

    Colimitation operator()(double ci) const {
        const double above = std::max(ci - compensation_, 0.0);
        const double per_electron = above / (4.5 * ci + 10.5 * compensation_);
        const double rubisco = vcmax_ * above / (ci + half_rate_);
        return {per_electron * yield_, per_electron * jmax_ * jmax_rise_,
                theta_, beta_, smooth_minimum(beta_, rubisco, triose_use_)};
    }

  private:
    double compensation_;  //!< G* [umol mol-1]
    double half_rate_;     //!< Kc (1 + O / Ko) [umol mol-1]
    double vcmax_, triose_use_;
    double jmax_, jmax_rise_;  //!< jmax at 25 deg C, and times its factor
    double yield_, theta_, beta_;
};

//! Respiration [umol m-2 s-1] at a temperature [deg C] (Bernacchi et al. 2001).
double dark_respiration(const FarquharLeaf& leaf, double temperature);

//! CO2 inside a leaf [umol mol-1] if stomata are optimal for the air's vapour
//! pressure deficit D [kPa]: ca g1 / (g1 + sqrt(D)), with D at least 0.05
//! (Medlyn et al. 2011, doi:10.1111/j.1365-2486.2010.02375.x).
//! @param g1 [kPa^0.5]
//! @param ambient CO2 of the air [umol mol-1]
double ci_of_optimal_stomata(double deficit, double g1, double ambient = 400);

}  // namespace ideotype
