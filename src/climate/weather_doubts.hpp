// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ideotype/core/error.hpp"

namespace ideotype {

//! Counts what is doubtful about a file; like findings become one warning.
class Doubts {
  public:
    explicit Doubts(std::string file) : file_(std::move(file)) {}

    //! One more finding of this text.
    void count(int line, const std::string& text);

    //! A finding that there is one of.
    void note(int line, const std::string& text);

    //! "text (N times)" of counted ones, with the place of the first.
    std::vector<Problem> warnings() const;

  private:
    struct Doubt {
        std::string text;
        int line;
        int count;
    };
    std::string file_;
    std::vector<Doubt> doubts_;
};

}  // namespace ideotype
