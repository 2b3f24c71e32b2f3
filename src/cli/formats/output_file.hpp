// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <iterator>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace ideotype {

//! @throws Error (refused) if there is something at this path.
void require_new(const std::string& path);

//! A file that has its name once it is complete: until then it is written
//! aside, and removed if that fails. What is no plain file, such as a pipe, is
//! written directly.
class OutputFile {
  public:
    //! @throws Error
    explicit OutputFile(const std::string& path);
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    ~OutputFile();

    //! @throws Error if the disk is full, for example.
    template <class... Values>
    void print(fmt::format_string<Values...> form, Values&&... values) {
        constexpr std::size_t block = 1 << 16;
        fmt::format_to(std::back_inserter(text_), form,
                       std::forward<Values>(values)...);
        if (text_.size() >= block) flush();
    }

    //! Gives the file its name. @throws Error
    void finish();

  private:
    void flush();
    [[noreturn]] void fail() const;

    std::string path_;
    std::string target_;   //!< where symbolic links lead to
    std::string written_;  //!< the same, or a file beside it
    std::FILE* file_ = nullptr;
    fmt::memory_buffer text_;
};

}  // namespace ideotype
