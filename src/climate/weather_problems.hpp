// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ideotype/core/error.hpp"
#include "weather_layout.hpp"

namespace ideotype {

//! Collects problems of a file, up to a number that can still be read.
class Problems {
  public:
    explicit Problems(std::string file) : file_(std::move(file)) {}

    void add(int line, int column, std::string what);

    //! @throws InputError if there are any.
    void stop_if_any() const;

    //! @throws InputError of all and of this.
    [[noreturn]] void stop(int line, int column, std::string what);

  private:
    std::string file_;
    std::vector<Problem> problems_;
    int left_out_ = 0;
};

//! The index of the column of this name; adds a problem if there is not one.
std::optional<std::size_t> column_index(const Layout& layout,
                                        const std::string& name,
                                        Problems& problems);

//! The entry of a row; empty if the row is too short.
CsvField entry(const std::vector<CsvField>& fields, std::size_t index);

}  // namespace ideotype
