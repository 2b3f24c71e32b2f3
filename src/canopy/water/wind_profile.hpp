// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ideotype {

//! Returns the wind at the top of a canopy [m s-1]. Two logarithmic profiles
//! are used: above short grass, where wind is measured, up to 10 m, and from
//! there down to a canopy with displacement height 0.67 h and roughness length
//! 0.1 h (Campbell and Norman 1998; Allen et al. 1998, FAO 56, equation 47).
//! Winds too weak for anemometers are raised to 0.3 m s-1.
//! @param wind,height wind [m s-1] and its measurement height [m]
//! @param canopy height h of the canopy [m]
double wind_at_top(double wind, double height, double canopy);

//! Returns the aerodynamic resistance from a canopy to 10 m above the ground [s
//! m-1], ln((z - d) / z0)^2 / (0.41^2 u), without the effect of stability.
double aerodynamic_resistance(double wind, double height, double canopy);

}  // namespace ideotype
