// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include <sys/stat.h>

namespace ideotype {

//! "a folder", "a named pipe", "a socket" or "a device".
std::string kind_of(const struct stat& status);

//! The text of a file, or why there is none.
struct FileText {
    std::string text;
    bool is_there = false;
    //! "": there is no such file; else "a folder, no regular file" and the like
    std::string why;

    //! "cannot read PATH", with the reason if it is not that it is missing.
    std::string refusal(const std::string& path) const;
};

//! Campaigns, plants and crops are some kilobytes.
inline constexpr std::uintmax_t most_input_bytes = 16U << 20U;

//! Weather of years and meshes of millions of faces [bytes].
inline constexpr std::uintmax_t most_data_bytes = 1U << 30U;

//! Reads a regular file, so that it neither waits for a pipe nor reads a device
//! for ever, if it has no more bytes than that.
FileText read_file(const std::string& path, std::uintmax_t most);

}  // namespace ideotype
