// SPDX-License-Identifier: Apache-2.0
#include "place.hpp"

#include <cerrno>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <sys/stat.h>

#include "history.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/file.hpp"

namespace ideotype {

bool history_exists(const std::string& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0) {
        const int reason = errno;
        if (reason == ENOENT || reason == ENOTDIR) return false;
        throw Error(fmt::format(
            "{}: cannot be opened ({}); {}", path,
            std::generic_category().message(reason),
            reason == ELOOP ? "its symbolic links lead in a circle: remove them"
                            : "choose a path that can be read"));
    }
    if (S_ISREG(status.st_mode)) return true;
    throw Error(fmt::format("{}: not a history of ideotype ({}); name a file",
                            path, kind_of(status)),
                ExitCode::refused);
}

bool is_at(const std::string& path, int descriptor) {
    struct stat opened {};
    struct stat named {};
    return fstat(descriptor, &opened) == 0 && stat(path.c_str(), &named) == 0 &&
           opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

}  // namespace ideotype
