// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "dataset.hpp"
#include "generations.hpp"
#include "handle.hpp"
#include "search/outcome.hpp"

namespace ideotype {

// analysis/FORMAT.md lists the data that enter each checksum.

//! Length of a checksum in hexadecimal digits.
inline constexpr std::size_t checksum_size = 64;

//! Computes the SHA-256 of all data known before the first evaluation.
std::string header_checksum(hid_t file);

//! Computes SHA-256 checksums of generations, each over its rows and its
//! summary. The first checksum takes longest, because it opens all datasets.
class GenerationChecksums {
  public:
    //! Opens the datasets. The file and the mapping must outlive this object.
    //! @param mapping mapping of the file; if null, HDF5 reads the file
    GenerationChecksums(hid_t file, const Mapping* mapping);
    ~GenerationChecksums();

    std::string compute(std::uint32_t generation, const Span& rows);

  private:
    struct Tables;
    hid_t file_;
    const Mapping* mapping_;
    std::unique_ptr<Tables> tables_;
};

//! Computes the SHA-256 of a row of /final. The status is an argument because
//! the file receives it only after the checksum.
std::string finalist_checksum(hid_t file, hsize_t row, Status status);

//! Verifies the checksum of the header.
//! @throws Error (refused) if they differ.
void require_header_intact(hid_t file, const std::string& path);

//! Verifies the checksum of a complete generation.
//! @throws Error (refused) if they differ.
void require_intact(GenerationChecksums& checksums,
                    const Generations& generations, std::uint32_t generation,
                    const std::string& path);

//! Verifies the checksums of the header, all complete generations and all
//! recorded finalists.
//! @throws Error (refused) at the first that differs.
void require_intact(hid_t file, const std::string& path);

}  // namespace ideotype
