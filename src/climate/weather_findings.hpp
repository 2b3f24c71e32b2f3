// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ideotype/core/error.hpp"

namespace ideotype {

//! Collects what is wrong with a file, and what is doubtful about it.
class Findings {
  public:
    explicit Findings(std::string file) : file_(std::move(file)) {}

    //! Adds a problem. More than can be read are only counted.
    void add(int line, int column, std::string what);

    //! @throws InputError if there are problems.
    void stop_if_any() const;

    //! @throws InputError of all problems and of this.
    [[noreturn]] void stop(int line, int column, std::string what);

    //! Counts a doubt; those of the same text become one warning.
    void doubt(int line, const std::string& text);

    //! Adds a doubt that there is one of.
    void note(int line, const std::string& text);

    //! Returns "text (N times)" of each doubt, with the place of the first.
    std::vector<Problem> warnings() const;

  private:
    struct Doubt {
        std::string text;
        int line;
        int count;
    };
    std::string file_;
    std::vector<Problem> problems_;
    std::vector<Doubt> doubts_;
    int left_out_ = 0;
};

}  // namespace ideotype
