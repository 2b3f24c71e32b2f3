// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! Lines to the standard output, each at once.
class LineWriter {
  public:
    LineWriter();
    ~LineWriter();
    LineWriter(const LineWriter&) = delete;
    LineWriter& operator=(const LineWriter&) = delete;

    //! @throws Error if nobody reads them any more, or the disk is full.
    void write(const std::string& line) const;

  private:
    int file_;
};

}  // namespace ideotype
