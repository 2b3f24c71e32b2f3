// SPDX-License-Identifier: Apache-2.0
#include "open.hpp"

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>
#include <sys/stat.h>

#include "history/checksum.hpp"
#include "history/journal.hpp"
#include "history/layout.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype {

namespace {

std::string system_reason() {
    return std::generic_category().message(errno);
}

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
    throw Error(path + ": " + reason, ExitCode::refused);
}

struct Length {
    std::uint64_t present = 0;
    std::uint64_t expected = 0;
    unsigned char superblock = 0;  //!< version of the superblock
};

// Returns the length of a file and the length that HDF5 recorded in its
// superblock. A truncated file can be opened and reads as zeros beyond its end,
// so only the difference of lengths reveals the loss. This program writes
// superblocks of version 3; h5repack writes version 0 by default.
Length read_length(const std::string& path) {
    constexpr std::array<unsigned char, 8> start{0x89, 'H',  'D',  'F',
                                                 '\r', '\n', 0x1a, '\n'};
    std::array<unsigned char, 52> block{};
    if (!history_exists(path)) throw Error(path + ": there is no such file");
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) throw Error(path + ": " + system_reason());
    const ssize_t size = pread(descriptor, block.data(), block.size(), 0);
    struct stat status {};
    const bool is_known = fstat(descriptor, &status) == 0;
    ::close(descriptor);
    if (size < 0 || !is_known) throw Error(path + ": " + system_reason());
    if (std::memcmp(block.data(), start.data(), start.size()) != 0)
        refuse(path, "this is not a history of ideotype");
    const unsigned char version = block[start.size()];
    const std::size_t length_offset = version == 0   ? 40
                                      : version == 1 ? 44
                                                     : 28;
    std::uint64_t length = 0;
    for (std::size_t i = 8; i-- > 0;)
        length = length << 8U | block[length_offset + i];
    return {static_cast<std::uint64_t>(status.st_size), length, version};
}

std::string describe_truncation(const Length& length) {
    return fmt::format("truncated: {} of {} bytes are left", length.present,
                       length.expected);
}

Length refuse_truncated(const std::string& path) {
    const Length length = read_length(path);
    if (length.present < length.expected)
        refuse(path,
               describe_truncation(length) +
                   "; copy it again, or save the generations that are left "
                   "with: ideotype export FILE --generations --to NEW.csv");
    return length;
}

Handle open_without_lock(const std::string& path, hid_t access) {
    return {H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access),
            H5Fclose, "open the file"};
}

std::string read_version(const std::string& path, hid_t file) {
    if (text_attribute(file, "format") != format_name)
        refuse(path, "this is not a history of ideotype");
    return text_attribute(file, "format_version");
}

//! Returns whether h5repack has rewritten a history with chunked datasets.
bool is_compressed(hid_t file) {
    const std::string action = "read a layout";
    const Handle genome(H5Dopen2(file, "evaluations/genome", H5P_DEFAULT),
                        H5Dclose, action);
    const Handle form(H5Dget_create_plist(genome), H5Pclose, action);
    return H5Pget_layout(form) == H5D_CHUNKED;
}

[[noreturn]] void refuse_version(const std::string& path,
                                 const std::string& version,
                                 const std::string& known) {
    refuse(path, fmt::format(
                     "this history has format version {}, but this program {}",
                     version.empty() ? "unknown" : version, known));
}

void require_readable(const std::string& path, hid_t file) {
    if (const std::string version = read_version(path, file);
        !version.starts_with("2."))
        refuse_version(path, version,
                       version.starts_with("1.")
                           ? "reads only 2.x; ideotype 0.2.1 reads it"
                           : "reads only 2.x");
}

}  // namespace

Handle access_properties() {
    initialize_hdf5();
    const std::string action = "prepare the file access";
    Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, action);
    checked(H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110),
            action);
    // FileLock excludes other writers, and readers need no lock.
    checked(H5Pset_file_locking(access, false, true), action);
    // Without this buffer, every write reaches the operating system at once and
    // is visible to readers of the file.
    checked(H5Pset_sieve_buf_size(access, 0), action);
    // If the checksum of a block is wrong, HDF5 reads the block again, doubling
    // the wait each time. With 30 attempts it waits about a second, enough for
    // a live file; with the default of 100 it would never end for a damaged
    // file.
    checked(H5Pset_metadata_read_attempts(access, 30), action);
    return access;
}

Handle open_to_write(const std::string& path) {
    if (refuse_truncated(path).superblock < 3)
        refuse(
            path,
            "h5repack has rewritten this history so that it cannot be resumed; "
            "repack it again with the option -L");
    const Handle access = access_properties();
    // After a writer was killed, the file is still marked as open. Clear the
    // mark, as h5clear does.
    const hbool_t yes = true;
    checked(H5Pset(access, "clear_status_flags", &yes), "clear the flags");
    Handle file(
        H5Fopen(path.c_str(), H5F_ACC_RDWR | H5F_ACC_SWMR_WRITE, access),
        H5Fclose, "open the file to write");
    if (const std::string version = read_version(path, file);
        version != format_version)
        refuse_version(path, version,
                       std::string("resumes only ") + format_version);
    if (is_compressed(file) && !Journal(file).finished())
        refuse(path,
               "h5repack has rewritten this history before it was finished; "
               "continue with the original file");
    // A copy may lack the space that was reserved for the original.
    reserve_space(file, path, "free disk space and resume again");
    return file;
}

Handle open_as_it_is(const std::string& path) {
    refuse_truncated(path);
    Handle file = open_without_lock(path, access_properties());
    require_readable(path, file);
    return file;
}

Remains open_remains(const std::string& path) {
    const Length length = read_length(path);
    if (length.present >= length.expected) {
        Handle file = open_as_it_is(path);
        require_intact(file, path);
        return {std::move(file), length.present, 0};
    }
    try {
        const Handle access = access_properties();
        const hbool_t yes = true;
        checked(H5Pset(access, "skip_eof_check", &yes), "skip the check");
        Handle file = open_without_lock(path, access);
        require_readable(path, file);
        return {std::move(file), length.present,
                length.expected - length.present};
    } catch (const Hdf5Error&) {
        refuse(path, describe_truncation(length) +
                         ", too few to read any; copy it again");
    }
}

void flush(hid_t file) {
    checked(H5Fflush(file, H5F_SCOPE_LOCAL), "write");
}

int get_descriptor(hid_t file) {
    void* descriptor = nullptr;
    checked(H5Fget_vfd_handle(file, H5P_DEFAULT, &descriptor),
            "find the open file");
    return *static_cast<int*>(descriptor);
}

}  // namespace ideotype
