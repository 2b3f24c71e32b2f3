// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include <sys/stat.h>

namespace ideotype {

//! Describes the kind of a special file: "a folder", "a named pipe", "a socket"
//! or "a device".
std::string describe_kind(const struct stat& status);

//! The text of a file, or why it could not be read.
struct FileText {
    std::string text;
    bool is_there = false;
    //! Why the text is missing: "" if there is no file, otherwise a text such
    //! as "a folder, no regular file".
    std::string why;

    //! Returns "cannot read PATH", with the reason unless there is no such
    //! file.
    std::string refusal(const std::string& path) const;
};

//! Largest accepted size of campaign, plant and crop files, which usually take
//! a few kilobytes [bytes].
inline constexpr std::uintmax_t most_input_bytes = 16U << 20U;

//! Largest accepted size of weather and mesh files, which may cover years or
//! millions of faces [bytes].
inline constexpr std::uintmax_t most_data_bytes = 1U << 30U;

//! Reads a regular file up to a size [bytes]. Other files are refused: reading
//! a pipe may block and a device may never end.
FileText read_file(const std::string& path, std::uintmax_t limit);

}  // namespace ideotype
