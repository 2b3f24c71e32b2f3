// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "ideotype/climate/sun.hpp"

namespace ideotype {

//! Returns the text of a campaign file with the most important keys, their
//! units and meanings. Light lasts from sunrise to sunset.
//! @param site place with the name of the campaign
//! @param bounds "\n" and a line of the table [plant], or ""
//! @throws Error if the sun does not rise.
std::string new_text(const Site& site, const Date& date, double row,
                     double plant, const std::string& baseline,
                     const std::string& bounds, const std::string& objective);

}  // namespace ideotype
