// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "ideotype/canopy/request.hpp"
#include "ideotype/core/estimate.hpp"
#include "ideotype/light/device.hpp"

namespace ideotype {

//! A level light sensor among the plants, such as a ceptometer: it receives the
//! light from above, and is long in the direction of the rows.
struct Sensor {
    double height = 0;  //!< height above the soil [m]
    //! Distance from a row, across the rows [m]. NaN: the sensor spans the
    //! whole distance between two rows evenly.
    double position = 0;
};

//! Finds the light on sensors in each instant of the light series, relative to
//! the light on level ground above the canopy, as a mean over places along the
//! rows and over fields; each randomisation has separate fields. Paths are
//! followed from the sensor back to the sources of light, so that the sensor
//! shades nothing.
//! @param points number of points on each sensor in each randomisation
//! @return [sensor, instant]
//! @throws Error if there are fewer than two randomisations or the plants do
//! not stand in a drawn field
std::vector<std::vector<Estimate>> light_on_sensors(
    const CanopyRequest& request, const Device& device,
    std::span<const Sensor> sensors, int points);

}  // namespace ideotype
