// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ideotype {

//! Diffuse over global light of an hour by its clearness index, which is
//! global over extraterrestrial horizontal irradiance (Erbs, Klein and Duffie
//! 1982, doi:10.1016/0038-092X(82)90302-4). Limits are those of pvlib: the
//! cosine of the zenith angle is at least 0.065 and the index at most 1 in
//! the correlation, and lower than 3 deg the sun has no beam.
//!
//! @param global [W m-2]
//! @param extraterrestrial_normal on a plane that faces the sun [W m-2]
//! @param zenith of the sun [deg]
double diffuse_fraction(double global, double extraterrestrial_normal,
                        double zenith);

}  // namespace ideotype
