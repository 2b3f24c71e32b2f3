// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "dataset.hpp"
#include "generations.hpp"
#include "handle.hpp"
#include "search/outcome.hpp"

namespace ideotype {

// What each is made of is written in analysis/FORMAT.md.

//! Characters of a checksum.
inline constexpr std::size_t checksum_size = 64;

//! SHA-256 of all that is known before the first evaluation.
std::string header_checksum(hid_t file);

//! SHA-256 of the rows and the summary of generations. Opens all their datasets
//! for the first, which takes longer than reading a generation.
class GenerationChecksums {
  public:
    //! Both must outlive it.
    //! @param mapping of the file, null: HDF5 reads it
    GenerationChecksums(hid_t file, const Mapping* mapping);
    ~GenerationChecksums();

    std::string of(std::uint32_t generation, const Span& rows);

  private:
    struct Tables;
    hid_t file_;
    const Mapping* mapping_;
    std::unique_ptr<Tables> tables_;
};

//! SHA-256 of a row of /final with this status, which is written later.
std::string finalist_checksum(hid_t file, hsize_t row, Status status);

//! @throws Error (refused) if the header does not have its checksum.
void require_header_intact(hid_t file, const std::string& path);

//! @throws Error (refused) if a complete generation does not have its
//! checksum.
void require_intact(GenerationChecksums& found, const Generations& generations,
                    std::uint32_t generation, const std::string& path);

//! Looks at the header, all complete generations and all recorded finalists.
//! @throws Error (refused) at the first that does not have its checksum.
void require_intact(hid_t file, const std::string& path);

}  // namespace ideotype
