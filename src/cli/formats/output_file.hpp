// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <iterator>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace ideotype {

//! Checks that nothing exists at the path of a new file.
//! @throws Error (refused) if anything does, even a dangling symbolic link.
void require_new(const std::string& path);

//! A new file that gets its final name only when it is complete, and never
//! replaces another file. Before, it has a temporary name in the same folder,
//! and is removed if writing fails. The program writes all files except
//! histories in this way.
class OutputFile {
  public:
    //! Opens the file.
    //! @throws Error if the file cannot be written, or (refused) by
    //! require_new().
    explicit OutputFile(const std::string& path);
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    ~OutputFile();

    //! Writes text.
    //! @throws Error if writing fails, for example on a full disk.
    template <class... Values>
    void print(fmt::format_string<Values...> form, Values&&... values) {
        constexpr std::size_t block = 1 << 16;
        fmt::format_to(std::back_inserter(text_), form,
                       std::forward<Values>(values)...);
        if (text_.size() >= block) flush();
    }

    //! Gives the file its final name.
    //! @throws Error if the file cannot be written, or (refused) if another
    //! file has been created under the name meanwhile.
    void finish();

  private:
    void flush();
    [[noreturn]] void fail() const;

    std::string path_;
    std::string part_;  //!< temporary path; "" when the file is complete
    std::FILE* file_ = nullptr;
    fmt::memory_buffer text_;
};

}  // namespace ideotype
