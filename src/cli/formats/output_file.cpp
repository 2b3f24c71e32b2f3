// SPDX-License-Identifier: Apache-2.0
#include "output_file.hpp"

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "ideotype/core/error.hpp"

namespace ideotype {

namespace fs = std::filesystem;

void require_new(const std::string& path) {
    if (fs::exists(path))
        throw Error(path + ": exists already and is not overwritten",
                    ExitCode::refused);
}

OutputFile::OutputFile(const std::string& path) : path_(path), target_(path) {
    std::error_code unknown;
    if (fs::exists(path, unknown)) target_ = fs::canonical(path, unknown);
    const bool is_special =
        fs::exists(target_, unknown) && !fs::is_regular_file(target_, unknown);
    written_ = is_special ? target_ : target_ + ".part";
    // Removes the rest of a killed process, but never the target of a link.
    if (!is_special) fs::remove(written_, unknown);
    file_ = std::fopen(written_.c_str(), is_special ? "wb" : "wbx");
    if (!file_) fail();
    std::setbuf(file_, nullptr);
}

OutputFile::~OutputFile() {
    if (!file_) return;
    std::fclose(file_);
    std::error_code unknown;
    if (written_ != target_) fs::remove(written_, unknown);
}

void OutputFile::finish() {
    flush();
    // Some file systems report a full disk only when a file is closed.
    if (std::fclose(std::exchange(file_, nullptr)) == 0 &&
        (written_ == target_ ||
         std::rename(written_.c_str(), target_.c_str()) == 0))
        return;
    const int reason = errno;
    std::error_code unknown;
    if (written_ != target_) fs::remove(written_, unknown);
    errno = reason;
    fail();
}

void OutputFile::flush() {
    if (std::fwrite(text_.data(), 1, text_.size(), file_) != text_.size())
        fail();
    text_.clear();
}

void OutputFile::fail() const {
    throw Error(fmt::format("{}: this file cannot be written: {}", path_,
                            std::generic_category().message(errno)));
}

}  // namespace ideotype
