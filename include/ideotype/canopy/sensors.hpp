// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "ideotype/canopy/request.hpp"
#include "ideotype/core/estimate.hpp"
#include "ideotype/light/device.hpp"

namespace ideotype {

//! A level light sensor among the plants, as of a ceptometer: it is met by what
//! comes from above, and is long in the direction of the rows.
struct Sensor {
    double height = 0;  //!< above the soil [m]
    //! Distance from a row, across the rows [m]. NaN: the sensor reaches evenly
    //! over the whole distance between two rows.
    double position = 0;
};

//! Finds the light on sensors in each instant of the scenario, relative to the
//! light on level ground above the canopy. It is the mean over places along the
//! rows and over fields, of which each randomisation has its own. Paths are
//! followed from the sensor back to the sources of light, so that it shades
//! nothing.
//! @param points on each sensor in each randomisation
//! @return [sensor, instant]
//! @throws Error if there are fewer than two randomisations or the plants are
//! not those of a field that is drawn
std::vector<std::vector<Estimate>> light_on_sensors(
    const CanopyRequest& request, const Device& device,
    std::span<const Sensor> sensors, int points);

}  // namespace ideotype
