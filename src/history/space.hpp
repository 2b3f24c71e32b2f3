// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "handle.hpp"

namespace ideotype {

//! Takes room on the disk for the whole file, so that no later write can meet
//! a full one. Where the file system can't do that, looks whether there is
//! enough. path names the file to the user. @throws Error saying how much is
//! needed and how much is free, with this advice.
void reserve_space(hid_t file, const std::string& path,
                   const std::string& advice);

//! @throws Error as above if there is less room than for so many bytes.
void require_room(const std::string& path, std::uint64_t bytes,
                  const std::string& advice);

//! Whether the file has all the room that it will ever need, and lacks no byte.
bool has_all_room(hid_t file);

//! "12.3 MiB are needed and 0.5 MiB are free", or empty if the file has all
//! the room that it will ever need.
std::string lacking_space(const std::string& path);

}  // namespace ideotype
