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

    //! Returns the number of generations that fit in the file.
    std::uint32_t capacity() const {
        return static_cast<std::uint32_t>(committed_.rows());
    }

    //! Returns the number of complete generations, which precede all others.
    std::uint32_t committed() const;

    //! Returns the rows of a generation; none before it is proposed.
    Span span(std::uint32_t generation) const;
    void set_span(std::uint32_t generation, const Span& span);

    std::vector<GenerationSummary> read(std::uint32_t count) const;

    //! Writes the summary of a generation; its best slot is stored as a row.
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
    std::vector<Dataset> numbers_;  //!< datasets of number_columns, in order
    std::vector<Dataset> counts_;   //!< datasets of integer_columns, in order
    Dataset checksum_;
};

}  // namespace ideotype
