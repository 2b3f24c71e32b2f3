// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dataset.hpp"
#include "history.hpp"

namespace ideotype {

//! Consecutive rows of /evaluations, such as those of a generation.
struct Span {
    hsize_t first = 0;
    hsize_t count = 0;

    hsize_t end() const { return first + count; }
};

//! The table /generations: the rows of each generation and its summary.
class Generations {
  public:
    static void create(hid_t file, const HistoryHeader& header);

    explicit Generations(hid_t file);

    //! Returns the number of generations for which the file has room.
    std::uint32_t capacity() const {
        return static_cast<std::uint32_t>(committed_.rows());
    }

    //! Returns the number of complete generations. They precede all others.
    std::uint32_t committed() const;

    //! Returns the rows of a generation; an empty span before it is proposed.
    Span span(std::uint32_t generation) const;
    void set_span(std::uint32_t generation, const Span& span);

    std::vector<GenerationSummary> read(std::uint32_t count) const;

    //! Writes the summary of a generation. Its best slot is stored as a row
    //! number.
    void write(std::uint32_t generation, const GenerationSummary& summary);

    std::string checksum(std::uint32_t generation) const {
        return checksum_.read_text(generation, 1)[0];
    }
    void set_checksum(std::uint32_t generation, const std::string& checksum);
    //! Marks the first incomplete generation complete.
    void set_committed(std::uint32_t generation);

  private:
    Dataset committed_;
    Dataset first_row_;
    Dataset count_;
    Dataset best_row_;
    std::vector<Dataset> numbers_;  //!< datasets in the order of number_columns
    std::vector<Dataset> counts_;  //!< datasets in the order of integer_columns
    Dataset checksum_;
};

}  // namespace ideotype
