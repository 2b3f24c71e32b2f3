// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include <sys/stat.h>

namespace ideotype {

//! Returns the kind of a special file: "a folder", "a named pipe", "a socket"
//! or "a device".
std::string kind_of(const struct stat& status);

//! The text of a file, or the reason for its absence.
struct FileText {
    std::string text;
    bool is_there = false;
    //! The reason for the absence: "" if there is no file, else a text such as
    //! "a folder, no regular file".
    std::string why;

    //! Returns "cannot read PATH", with the reason unless no file has this
    //! path.
    std::string refusal(const std::string& path) const;
};

//! The largest size of files of campaigns, plants and crops, which have some
//! kilobytes [bytes].
inline constexpr std::uintmax_t most_input_bytes = 16U << 20U;

//! The largest size of files of weather and meshes, which may have years and
//! millions of faces [bytes].
inline constexpr std::uintmax_t most_data_bytes = 1U << 30U;

//! Reads a file. Only regular files within a limit of size [bytes] are read, so
//! that no pipe is waited for and no device is read for ever.
FileText read_file(const std::string& path, std::uintmax_t most);

}  // namespace ideotype
