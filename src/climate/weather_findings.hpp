// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"

namespace ideotype {

//! Collects what is wrong with a file, and what is doubtful about it.
class Findings {
  public:
    explicit Findings(std::string file) : file_(std::move(file)) {}

    //! Adds a problem. More than can be read are only counted.
    template <class... Args>
    void add(int line, int column, fmt::format_string<Args...> what,
             Args&&... args) {
        if (problems_.size() < 20)
            problems_.push_back(
                {{file_, line, column},
                 fmt::format(what, std::forward<Args>(args)...)});
        else
            ++left_out_;
    }

    //! @throws InputError if there are problems.
    void stop_if_any() const {
        if (problems_.empty()) return;
        std::vector<Problem> all = problems_;
        if (left_out_ > 0)
            all.push_back(
                {{file_}, fmt::format("{} more problems", left_out_)});
        throw InputError(std::move(all));
    }

    //! @throws InputError of one problem.
    template <class... Args>
    [[noreturn]] void stop(int line, int column,
                           fmt::format_string<Args...> what,
                           Args&&... args) const {
        throw InputError({{{file_, line, column},
                           fmt::format(what, std::forward<Args>(args)...)}});
    }

    //! Adds a doubt; those of the same text become one warning.
    void doubt(int line, const std::string& text, bool is_counted = true) {
        for (Doubt& each : doubts_)
            if (is_counted && each.text == text) {
                ++each.count;
                return;
            }
        doubts_.push_back({text, line, is_counted ? 1 : 0});
    }

    //! Returns "text (N times)" of each doubt, with the place of the first.
    std::vector<Problem> warnings() const {
        std::vector<Problem> all;
        for (const auto& [text, line, count] : doubts_)
            all.push_back({{file_, line, 1},
                           count == 0
                               ? text
                               : fmt::format("{} ({} time{})", text, count,
                                             count == 1 ? "" : "s")});
        return all;
    }

  private:
    struct Doubt {
        std::string text;
        int line;
        int count;  //!< 0 if there can be only one
    };
    std::string file_;
    std::vector<Problem> problems_;
    std::vector<Doubt> doubts_;
    int left_out_ = 0;
};

}  // namespace ideotype
