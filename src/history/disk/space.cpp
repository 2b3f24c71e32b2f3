// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <fcntl.h>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <sys/stat.h>

#include "ideotype/core/error.hpp"
#include "open.hpp"

namespace ideotype {

namespace {

namespace fs = std::filesystem;

double to_mebibytes(std::uintmax_t bytes) {
    return static_cast<double>(bytes) / (1 << 20);
}

fs::path find_folder(const std::string& path) {
    return fs::absolute(path).parent_path();
}

std::uintmax_t free_bytes(const std::string& path) {
    std::error_code failure;
    const fs::space_info space = fs::space(find_folder(path), failure);
    return failure ? 0 : space.available;
}

// Returns how many of the first `size` bytes of a file are not yet allocated.
std::uintmax_t missing_bytes(const struct stat& status, std::uintmax_t size) {
    const auto present = static_cast<std::uintmax_t>(status.st_blocks) * 512;
    return size - std::min(size, present);
}

std::string describe_space(std::uintmax_t needed, std::uintmax_t free) {
    return fmt::format("{:.2f} MiB are needed and {:.2f} MiB are free",
                       to_mebibytes(needed), to_mebibytes(free));
}

// Reserves space without posix_fallocate(), which may write to every block.
int allocate(int descriptor, std::uintmax_t size) {
    while (fallocate(descriptor, 0, 0, static_cast<off_t>(size)) != 0)
        if (errno != EINTR) return errno;
    return 0;
}

[[noreturn]] void refuse(const std::string& path, int failure,
                         std::uintmax_t needed, std::uintmax_t free,
                         const std::string& advice) {
    throw Error(fmt::format(
        "{}: there is not enough space for this history ({}): {} in {}; {}",
        path, std::generic_category().message(failure),
        describe_space(needed, free), find_folder(path).string(), advice));
}

}  // namespace

void reserve_space(hid_t file, const std::string& path,
                   const std::string& advice) {
    const std::string action = "reserve room";
    haddr_t size = 0;
    checked(H5Fget_eoa(file, &size), action);
    const int descriptor = get_descriptor(file);
    struct stat status {};
    if (fstat(descriptor, &status) != 0) throw_hdf5_error(action);
    const std::uintmax_t needed = missing_bytes(status, size);
    const std::uintmax_t free = free_bytes(path);

    int failure = allocate(descriptor, size);
    if (failure == EOPNOTSUPP || failure == ENOSYS)
        failure = needed <= free ? 0 : ENOSPC;
    if (failure != 0) refuse(path, failure, needed, free, advice);
}

void require_room(const std::string& path, std::uint64_t bytes,
                  const std::string& advice) {
    const std::uintmax_t free = free_bytes(path);
    if (bytes > free) refuse(path, ENOSPC, bytes, free, advice);
}

bool has_all_room(hid_t file) {
    haddr_t size = 0;
    checked(H5Fget_eoa(file, &size), "find the room of the file");
    struct stat status {};
    return fstat(get_descriptor(file), &status) == 0 &&
           static_cast<haddr_t>(status.st_size) >= size &&
           missing_bytes(status, size) == 0;
}

std::string lacking_space(const std::string& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0) return "";
    const std::uintmax_t needed =
        missing_bytes(status, static_cast<std::uintmax_t>(status.st_size));
    return needed == 0 ? "" : describe_space(needed, free_bytes(path));
}

}  // namespace ideotype
