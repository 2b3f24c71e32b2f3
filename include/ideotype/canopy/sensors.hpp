// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "ideotype/canopy/request.hpp"
#include "ideotype/core/estimate.hpp"
#include "ideotype/light/device.hpp"

namespace ideotype {

//! A level light sensor among the plants, such as a ceptometer. It receives
//! light from above and is long in the direction of the rows.
struct Sensor {
    double height = 0;  //!< height above the soil [m]
    //! Distance from a row, across the rows [m]. NaN: the sensor spans the
    //! whole distance between two rows.
    double position = 0;
};

//! Computes the light on sensors at each instant of the light series, relative
//! to the light on level ground above the canopy. Results are means over
//! positions along the rows and over fields; each randomisation uses separate
//! fields. Paths are traced from the sensor back to the light sources, so the
//! sensor does not shade the plants.
//! @param points number of points on each sensor in each randomisation
//! @return [sensor, instant]
//! @throws Error if there are fewer than two randomisations or the plants do
//! not stand in a random field
std::vector<std::vector<Estimate>> light_on_sensors(
    const CanopyRequest& request, const Device& device,
    std::span<const Sensor> sensors, int points);

}  // namespace ideotype
