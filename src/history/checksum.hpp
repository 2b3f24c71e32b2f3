#pragma once

#include <string>

#include "generations.hpp"
#include "handle.hpp"
#include "ideotype/search/outcome.hpp"

namespace ideotype {

// What each is made of is written in analysis/FORMAT.md.

//! Format 1 has none.
bool has_checksums(hid_t file);

//! SHA-256 of all that is known before the first evaluation.
std::string header_checksum(hid_t file);

//! SHA-256 of the rows and the summary of a generation.
std::string generation_checksum(hid_t file, std::uint32_t generation,
                                const Span& rows);

//! SHA-256 of a row of /final with this status, which is written later.
std::string finalist_checksum(hid_t file, hsize_t row, Status status);

//! Looks at the header, all complete generations and all recorded finalists.
//! @throws Error (refused) at the first that does not have its checksum.
void require_intact(hid_t file, const std::string& path);

}  // namespace ideotype
