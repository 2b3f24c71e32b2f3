// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "campaign/problems.hpp"

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

}  // namespace ideotype
