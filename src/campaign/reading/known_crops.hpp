// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ideotype {

//! Returns the crops that the program knows by name: those of campaigns/crops.
std::vector<std::string> known_crop_names();

//! Returns the text of the crop file of one of them; nothing if there is none
//! of this name.
std::optional<std::string> known_crop(const std::string& name);

}  // namespace ideotype
