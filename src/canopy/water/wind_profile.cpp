// SPDX-License-Identifier: Apache-2.0
#include "wind_profile.hpp"

#include <algorithm>
#include <cmath>

#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

constexpr double reference = 10;  //!< reference height [m]
constexpr double least_wind = 0.3;
constexpr double von_karman = 0.41;

double displacement(double canopy) {
    return 0.67 * canopy;
}

double roughness(double canopy) {
    return 0.1 * canopy;
}

//! Returns a canopy height, limited to the range of the wind profile [m].
double canopy_in_profile(double canopy) {
    return std::clamp(canopy, 0.05, 0.7 * reference);
}

//! Returns the wind 10 m above short grass from the wind at another height.
double wind_at_reference(double wind, double height) {
    const auto profile = [](double z) {
        return std::log(std::max(67.8 * z - 5.42, 2.));
    };
    return std::max(wind * profile(reference) / profile(height), least_wind);
}

}  // namespace

double wind_at_top(double wind, double height, double canopy) {
    IDEOTYPE_EXPECT(wind >= 0 && height > 0);
    const double h = canopy_in_profile(canopy);
    const double d = displacement(h), z0 = roughness(h);
    return wind_at_reference(wind, height) * std::log((h - d) / z0) /
           std::log((reference - d) / z0);
}

double aerodynamic_resistance(double wind, double height, double canopy) {
    IDEOTYPE_EXPECT(wind >= 0 && height > 0);
    const double h = canopy_in_profile(canopy);
    const double profile =
        std::log((reference - displacement(h)) / roughness(h));
    return profile * profile /
           (von_karman * von_karman * wind_at_reference(wind, height));
}

}  // namespace ideotype
