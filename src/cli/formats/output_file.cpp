// SPDX-License-Identifier: Apache-2.0
#include "output_file.hpp"

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <random>
#include <system_error>
#include <unistd.h>

#include "ideotype/core/error.hpp"

namespace ideotype {

namespace fs = std::filesystem;

namespace {

//! Returns a name for the incomplete file that no other process uses.
std::string name_of_part(const std::string& path) {
    return fmt::format("{}.{:08x}.part", path, std::random_device{}());
}

//! Renames a complete file unless the new name is in use. Returns whether it
//! was renamed; if not, errno states the reason.
bool give_name(const std::string& part, const std::string& path) {
    if (renameat2(AT_FDCWD, part.c_str(), AT_FDCWD, path.c_str(),
                  RENAME_NOREPLACE) == 0)
        return true;
    if (errno == EEXIST) require_new(path);
    // Some file systems, such as NFS, do not support RENAME_NOREPLACE.
    if (errno != EINVAL && errno != ENOSYS) return false;
    require_new(path);
    return std::rename(part.c_str(), path.c_str()) == 0;
}

}  // namespace

void require_new(const std::string& path) {
    std::error_code unknown;
    const fs::file_type type = fs::symlink_status(path, unknown).type();
    if (type == fs::file_type::symlink)
        throw Error(path +
                        ": this is a symbolic link, through which nothing is "
                        "written; remove it, or choose another output",
                    ExitCode::refused);
    if (type != fs::file_type::not_found && type != fs::file_type::none)
        throw Error(path + ": exists already and is not overwritten",
                    ExitCode::refused);
}

OutputFile::OutputFile(const std::string& path)
    : path_(path), part_(name_of_part(path)) {
    require_new(path);
    const int descriptor =
        ::open(part_.c_str(),
               O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor < 0) fail();
    file_ = fdopen(descriptor, "wb");
    std::setbuf(file_, nullptr);
}

OutputFile::~OutputFile() {
    if (file_ != nullptr) std::fclose(file_);
    if (!part_.empty()) unlink(part_.c_str());
}

void OutputFile::finish() {
    flush();
    // Some file systems report a full disk only when a file is closed.
    if (std::fclose(std::exchange(file_, nullptr)) != 0 ||
        !give_name(part_, path_))
        fail();
    part_.clear();
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
