// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include <sys/stat.h>

namespace ideotype {

//! Returns "a folder", "a named pipe", "a socket" or "a device".
std::string kind_of(const struct stat& status);

//! The text of a file, or why there is none.
struct FileText {
    std::string text;
    bool is_there = false;
    //! The reason why there is no text: "" if there is no such file, else "a
    //! folder, no regular file" and the like.
    std::string why;

    //! Returns "cannot read PATH", with the reason unless the file is missing.
    std::string refusal(const std::string& path) const;
};

//! The largest size of campaigns, plants and crops, which have some kilobytes
//! [bytes].
inline constexpr std::uintmax_t most_input_bytes = 16U << 20U;

//! The largest size of the weather of years and of meshes of millions of faces
//! [bytes].
inline constexpr std::uintmax_t most_data_bytes = 1U << 30U;

//! Reads a regular file that has no more bytes than the limit, so that it
//! neither waits for a pipe nor reads a device for ever.
FileText read_file(const std::string& path, std::uintmax_t most);

}  // namespace ideotype
