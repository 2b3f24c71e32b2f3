// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace ideotype {

//! Room that a file takes on the disk [bytes].
struct PackedSize {
    std::uintmax_t before = 0;
    std::uintmax_t after = 0;  //!< the same if it was packed before
};

//! Compresses a finished history (shuffle, deflate). The copy is written next
//! to it, forced to the disk, compared with it in every dataset and attribute,
//! and only then takes its place. @throws Error (refused) if the history is
//! not finished or in use; then, and after any failure, it is as it was.
PackedSize pack_file(const std::string& path);

}  // namespace ideotype
