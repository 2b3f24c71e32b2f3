// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ideotype {

//! Returns the names of the crops in campaigns/crops, known to the program.
std::vector<std::string> known_crop_names();

//! Returns the text of the crop file of a known crop; nothing if there is no
//! crop of this name.
std::optional<std::string> known_crop(const std::string& name);

}  // namespace ideotype
