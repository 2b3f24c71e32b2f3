// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace ideotype {

//! What a history has that was compared with checksums.
struct Verified {
    std::uint32_t generations = 0;
    std::uint32_t finalists = 0;
};

//! Reads all of a history, also while it is written, and compares header,
//! complete generations and finalists with their checksums.
//! @throws Error (refused) that names what is damaged.
Verified verify_file(const std::string& path);

}  // namespace ideotype
