// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "spec/problems.hpp"

namespace ideotype {

//! Converts a path that a campaign file contains to a path relative to the
//! working folder.
std::string path_from(const std::string& file, const std::string& path);

//! Returns the text of a campaign, crop or plant.
//! @throws Error if it cannot be read.
std::string read_text(const std::string& path);

//! Returns the text of a file that a key names. If the file cannot be read,
//! reports this and suggests a file with a similar name.
std::optional<std::string> text_of(const std::string& file,
                                   const std::string& named_by,
                                   const Location& named_at,
                                   const Problems& problems);

//! Returns the names of the built-in crops (campaigns/crops).
std::vector<std::string> known_crop_names();

//! Returns the crop file of a built-in crop, or nothing for other names.
std::optional<std::string> known_crop(const std::string& name);

}  // namespace ideotype
