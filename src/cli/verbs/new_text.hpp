// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "ideotype/climate/sun.hpp"

namespace ideotype {

//! Writes the text of a campaign file: all that matters, each key with its unit
//! and meaning. Light is from sunrise to sunset.
//! @param site with the name of the campaign
//! @param bounds "\n" and a line of the table [plant]; "": none
//! @throws Error if the sun does not rise.
std::string new_text(const Site& site, const Date& date, double row,
                     double plant, const std::string& baseline,
                     const std::string& bounds, const std::string& objective);

}  // namespace ideotype
