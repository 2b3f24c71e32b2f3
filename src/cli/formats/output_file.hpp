// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <iterator>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace ideotype {

//! Checks that a path is free for a new file.
//! @throws Error (refused) if anything exists at this path.
void require_new(const std::string& path);

//! A new file, which gets its name when it is complete. An incomplete file has
//! another name beside it, and is removed if writing fails. A pipe, or any
//! other special file, is written directly.
class OutputFile {
  public:
    //! Opens the file. @throws Error if the file cannot be written.
    explicit OutputFile(const std::string& path);
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    ~OutputFile();

    //! Writes text. @throws Error if writing fails, for example on a full disk.
    template <class... Values>
    void print(fmt::format_string<Values...> form, Values&&... values) {
        constexpr std::size_t block = 1 << 16;
        fmt::format_to(std::back_inserter(text_), form,
                       std::forward<Values>(values)...);
        if (text_.size() >= block) flush();
    }

    //! Gives the file its name. @throws Error if renaming fails.
    void finish();

  private:
    void flush();
    [[noreturn]] void fail() const;

    std::string path_;
    std::string target_;   //!< path to which symbolic links lead
    std::string written_;  //!< the target, or a file beside it
    std::FILE* file_ = nullptr;
    fmt::memory_buffer text_;
};

}  // namespace ideotype
