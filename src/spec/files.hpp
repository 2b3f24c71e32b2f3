// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "spec/problems.hpp"

namespace ideotype {

//! Returns a path named in a campaign file, relative to the current folder.
std::string path_from(const std::string& file, const std::string& path);

//! Returns the text of a campaign, crop or plant.
//! @throws Error if it cannot be read.
std::string read_text(const std::string& path);

//! Returns the text of a file that a key names; reports a file that cannot be
//! read, with a file of a similar name.
std::optional<std::string> text_of(const std::string& file,
                                   const std::string& named_by,
                                   const Location& named_at,
                                   const Problems& problems);

//! Returns the names of the crops in campaigns/crops, known to the program.
std::vector<std::string> known_crop_names();

//! Returns the text of the crop file of a known crop; nothing for other names.
std::optional<std::string> known_crop(const std::string& name);

}  // namespace ideotype
