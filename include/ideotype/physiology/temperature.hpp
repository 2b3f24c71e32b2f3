// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ideotype {

inline constexpr double kelvin = 273.15;  //!< 0 deg C [K]

//! The molar gas constant [kPa m3 mol-1 K-1], equal to [kJ mol-1 K-1].
inline constexpr double gas_constant = 8.314462618e-3;

inline constexpr double air_heat_capacity = 29.3;  //!< [J mol-1 K-1]

//! The Stefan-Boltzmann constant [W m-2 K-4].
inline constexpr double stefan_boltzmann = 5.670374419e-8;

//! Returns 2^((T - reference) / 10), a response that doubles every 10 deg C.
//! @param temperature [deg C]
double q10(double temperature, double reference);

//! Temperature response of C4 enzymes, about 1 at 25 deg C:
//!
//!     g(T) = 2^((T - 25) / 10) / [(1 + e^{0.3 (3 - T)}) (1 + e^{0.3 (T -
//!     37.5)})]
//!
//! (the form of Collatz et al. 1992, doi:10.1071/PP9920519; limits of 3 and
//! 37.5 deg C as in BioCro).
//! @param temperature leaf temperature [deg C]
double c4_temperature_response(double temperature);

//! Saturation pressure of water vapour over water [kPa] (Tetens 1930): 0.61078
//! exp(17.27 T / (T + 237.3)).
//! @param temperature [deg C]
double saturated_vapour(double temperature);

//! Vapour pressure deficit of air [kPa].
//! @param temperature [deg C]
//! @param humidity relative humidity, 0 to 1
double vapour_deficit(double temperature, double humidity);

}  // namespace ideotype
