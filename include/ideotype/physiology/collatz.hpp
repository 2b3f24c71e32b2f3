// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/physiology/hyperbola.hpp"

namespace ideotype {

//! Rates of a C4 leaf at 25 deg C (those of g(T), see collatz_at()); defaults
//! are those of BioCro.
struct CollatzLeaf {
    double vmax = 39;  //!< [umol m-2 s-1] (Collatz et al. 1992)
    //! Quantum yield [mol CO2 per mol of absorbed photons].
    double alpha = 0.067;
    double theta = 0.83;  //!< curvature of light and capacity [-]
    double beta = 0.93;   //!< curvature of those and CO2 [-]
    //! Initial slope of the response to CO2 [mol m-2 s-1].
    double k = 0.7;
    double respiration = 0.8;  //!< in the dark [umol m-2 s-1] (BioCro)
};

//! Response to light at a temperature [deg C] (Collatz et al. 1992,
//! doi:10.1071/PP9920519): with the capacity vmax g(T), and limited by CO2 to
//! k ci 2^((T - 25) / 10).
//! @param ci CO2 within the leaf [umol mol-1]
Colimitation collatz_at(const CollatzLeaf& leaf, double temperature, double ci);

//! The effect of temperature on the rates of a C4 leaf, over those at 25 deg C.
struct CollatzFactors {
    explicit CollatzFactors(double temperature);

    double capacity;     //!< temperature response of vmax
    double co2;          //!< temperature response of k
    double respiration;  //!< factor of respiration in the dark
};

//! As collatz_at(), for many values of CO2 at once.
class CollatzAt {
  public:
    CollatzAt(const CollatzLeaf& leaf, double temperature)
        : CollatzAt(leaf, CollatzFactors(temperature)) {}

    CollatzAt(const CollatzLeaf& leaf, const CollatzFactors& factors)
        : without_co2_{leaf.alpha, leaf.vmax * factors.capacity, leaf.theta,
                       leaf.beta, 0},
          slope_(leaf.k * factors.co2) {}

    Colimitation operator()(double ci) const {
        Colimitation response = without_co2_;
        response.limit = slope_ * ci;
        return response;
    }

  private:
    Colimitation without_co2_;
    double slope_;  //!< slope of the response to CO2 [mol m-2 s-1]
};

//! Dark respiration [umol m-2 s-1] at a temperature [deg C]:
//! R 2^((T - 25) / 10) / (1 + e^{1.3 (T - 55)}).
double dark_respiration(const CollatzLeaf& leaf, double temperature);

//! CO2 within a leaf [umol mol-1] with stomata that follow the air's vapour
//! pressure deficit [kPa]: ca (0.84 - 0.19 VPD), not below 0 (as in
//! DCaPST).
//! @param ambient CO2 of the air [umol mol-1]
double ci_of_deficit(double deficit, double ambient = 400);

}  // namespace ideotype
