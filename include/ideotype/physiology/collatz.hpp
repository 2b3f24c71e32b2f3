// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/physiology/hyperbola.hpp"

namespace ideotype {

//! Rates of a C4 leaf at 25 deg C, to which the temperature responses of
//! collatz_at() apply. Defaults are those of BioCro.
struct CollatzLeaf {
    double vmax = 39;  //!< [umol m-2 s-1] (Collatz et al. 1992)
    //! Quantum yield [mol CO2 per mol of absorbed photons].
    double alpha = 0.067;
    double theta = 0.83;  //!< curvature between light and capacity [-]
    //! Curvature between M, the minimum of light and capacity, and CO2 [-].
    double beta = 0.93;
    //! Initial slope of the response to CO2 [mol m-2 s-1].
    double k = 0.7;
    double respiration = 0.8;  //!< dark respiration [umol m-2 s-1] (BioCro)
};

//! Response to light at a temperature T [deg C] (Collatz et al. 1992,
//! doi:10.1071/PP9920519). The capacity is vmax g(T), the limit by CO2 is k ci
//! 2^((T - 25) / 10).
//! @param ci CO2 inside the leaf [umol mol-1]
Colimitation collatz_at(const CollatzLeaf& leaf, double temperature, double ci);

//! Factors of the rates of a C4 leaf at a temperature, relative to 25 deg C.
struct CollatzFactors {
    CollatzFactors() = default;
    explicit CollatzFactors(double temperature);

    double capacity;     //!< temperature response of vmax
    double co2;          //!< temperature response of k
    double respiration;  //!< temperature response of dark respiration
};

//! Like collatz_at(), but faster for many values of CO2.
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

//! CO2 inside a leaf [umol mol-1] if stomata respond to the air's vapour
//! pressure deficit [kPa]: ca (0.84 - 0.19 VPD), at least 0 (as in DCaPST).
//! @param ambient CO2 of the air [umol mol-1]
double ci_of_deficit(double deficit, double ambient = 400);

}  // namespace ideotype
