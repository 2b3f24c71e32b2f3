// SPDX-License-Identifier: Apache-2.0
#include <cerrno>
#include <cstdint>
#include <fcntl.h>
#include <filesystem>
#include <system_error>
#include <unistd.h>

#include <fmt/format.h>

#include "history/checksum.hpp"
#include "history/columns.hpp"
#include "history/generations.hpp"
#include "history/journal.hpp"
#include "history/layout.hpp"
#include "ideotype/core/error.hpp"
#include "open.hpp"

namespace ideotype {

namespace {

constexpr auto smaller_history =
    "free disk space, choose another folder with --out, or reduce "
    "stop.generations";

void write_tables(hid_t file, const HistoryHeader& header) {
    write_header(file, header);
    // Large tables come last, since a truncated file loses its end.
    Generations::create(file, header);
    Journal::create(file);
    Columns::create(
        file, header.genes, header.final_schema(),
        {.group = "final",
         .rows = counted("finalist", "0 is the baseline",
                         static_cast<std::size_t>(header.finalists)),
         .has_checksums = true});
    Columns::create(file, header.genes, header.schema,
                    {.group = "evaluations",
                     .rows = counted("row", "generation after generation",
                                     static_cast<std::size_t>(header.rows())),
                     .room = Room::as_needed});
    create_attribute(file, "checksum", header_checksum(file));
}

void place_objects(hid_t access) {
    // A kill can split a write at the end of a memory page. It cannot split a
    // number that is aligned to its size.
    checked(H5Pset_alignment(access, 8, 8), "align the datasets");
    // The metadata of all datasets come first, so that a truncated file can be
    // opened.
    checked(H5Pset_meta_block_size(access, 1 << 18), "place the descriptions");
    // References to scales are stored with small data.
    checked(H5Pset_small_data_block_size(access, 1 << 17),
            "place the descriptions");
}

Handle create_in_memory(const HistoryHeader& header) {
    initialize_hdf5();
    const std::string action = "create a file in memory";
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, action);
    checked(H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110),
            action);
    checked(H5Pset_fapl_core(access, 1 << 20, false), action);
    place_objects(access);
    Handle file(H5Fcreate("in memory", H5F_ACC_TRUNC, H5P_DEFAULT, access),
                H5Fclose, action);
    write_tables(file, header);
    return file;
}

// Returns the size of a file with a number of generations. The file is created
// in memory.
std::uint64_t measure_bytes(HistoryHeader header, int generations) {
    header.generations = generations;
    const std::string action = "measure a file";
    const Handle file = create_in_memory(header);
    flush(file);
    return static_cast<std::uint64_t>(
        checked(H5Fget_file_image(file, nullptr, 0), action));
}

//! Waits until the data of an open file are on the disk; returns 0 or an error
//! number.
int wait_for_disk(int descriptor) {
    while (fsync(descriptor) != 0)
        if (errno != EINTR) return errno;
    return 0;
}

//! Waits until the data of a closed file or a folder are on the disk.
void synchronize_path(const std::filesystem::path& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
        throw Error(path.string() + ": " +
                    std::generic_category().message(errno));
    const int failure = wait_for_disk(descriptor);
    ::close(descriptor);
    // Some file systems cannot synchronise a folder.
    if (failure == 0 || failure == EINVAL) return;
    throw Error(
        fmt::format("{}: this file cannot be written to the disk: {}; check "
                    "the disk, or choose another folder with --out",
                    path.string(), std::generic_category().message(failure)));
}

//! Renames a complete file atomically, so that either the old or the new file
//! exists at any time.
void rename_file(const std::string& source, const std::string& target) {
    std::error_code failure;
    std::filesystem::rename(source, target, failure);
    if (failure) throw Error(target + ": " + failure.message());
    synchronize_path(std::filesystem::absolute(target).parent_path());
}

}  // namespace

std::uint64_t history_bytes(const HistoryHeader& header) {
    // Every dataset is one block aligned to 8 bytes. The size of the file is
    // therefore linear in the number of generations, in steps of 8.
    constexpr int step = 8;
    if (header.generations <= 2 * step)
        return measure_bytes(header, header.generations);
    const std::uint64_t small = measure_bytes(header, step);
    const std::uint64_t large = measure_bytes(header, 2 * step);
    const auto more = static_cast<std::uint64_t>(header.generations - step);
    return small + (large - small) * more / step;
}

void create_file(const std::string& path, const HistoryHeader& header,
                 const FileLock& lock) {
    // With more rows than this, the row numbers alone could fill a disk before
    // any space is reserved.
    constexpr int many = 1'000'000;
    if (header.rows() > many)
        require_room(path, history_bytes(header), smaller_history);
    const Handle access = access_properties();
    place_objects(access);
    const std::string unfinished = lock.open_path();
    Handle file(
        H5Fcreate(unfinished.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access),
        H5Fclose, "create the file");
    write_tables(file, header);
    reserve_space(file, path, smaller_history);
    flush(file);
    file.close("write the file");
    synchronize_path(unfinished);
    rename_file(path + ".new", path);
    if (!lock.locks(path))
        throw Error(
            path +
                ": this file was deleted, moved or replaced while it was "
                "created; start again",
            ExitCode::refused);
}

void synchronize(hid_t file) {
    if (const int failure = wait_for_disk(get_descriptor(file)); failure != 0)
        throw Hdf5Error("the history cannot be written: " +
                        std::generic_category().message(failure));
}

}  // namespace ideotype
