// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "file_lock.hpp"
#include "history/handle.hpp"
#include "history/history.hpp"

namespace ideotype {

inline constexpr const char* format_name = "ideotype-history";
inline constexpr const char* format_version = "2.0";

//! Writes the root attributes, /campaign, /genes and /objectives.
void write_header(hid_t file, const HistoryHeader& header);

//! Reads the header that write_header() wrote, and the schemas of outcomes from
//! the tables of rows.
HistoryHeader read_header(hid_t file);

//! Creates a history with all its datasets. A file of the final name is always
//! complete.
//! @param lock lock from FileLock::create_new() for this path
//! @throws Error, Hdf5Error
void create_file(const std::string& path, const HistoryHeader& header,
                 const FileLock& lock);

//! Returns the HDF5 properties with which files are opened and created.
Handle access_properties();

//! Opens a file as its only writer, also if the last writer was killed. The
//! caller must hold the FileLock.
//! @throws Error (refused) if the file is not a history.
Handle open_to_write(const std::string& path);

//! Opens a history for reading, also while it is written or after its writer
//! was killed.
//! @throws Error (refused) if the file is not a history, or has another major
//! format version.
Handle open_as_it_is(const std::string& path);

//! A file that may have been truncated.
struct Remains {
    Handle file;
    std::uint64_t bytes = 0;    //!< bytes that still exist
    std::uint64_t missing = 0;  //!< bytes lost at the end
};

//! Opens a history that may be truncated; lost parts read as zeros.
//! @throws Error (refused) if the file is not a history or too little of it is
//! left.
Remains open_remains(const std::string& path);

//! Passes all writes to the operating system, so that they survive SIGKILL.
void flush(hid_t file);

//! Waits until all writes are on the disk, so that they survive a power
//! failure.
void synchronize(hid_t file);

//! Returns the file descriptor of an open HDF5 file.
int get_descriptor(hid_t file);

//! Reserves disk space for the whole file, so that no later write fails on a
//! full disk. If the file system cannot reserve space, the free space is
//! checked.
//! @param path name of the file in messages
//! @throws Error that states the space needed, the free space and the advice
void reserve_space(hid_t file, const std::string& path,
                   const std::string& advice);

//! Checks that a number of bytes is free on the disk.
//! @throws Error like reserve_space() if fewer are free.
void require_room(const std::string& path, std::uint64_t bytes,
                  const std::string& advice);

//! Returns whether the file has no holes and occupies all the space it will
//! ever need.
bool has_all_room(hid_t file);

//! Returns a text such as "12.3 MiB are needed and 0.5 MiB are free", or "" if
//! the file occupies all the space it will ever need.
std::string lacking_space(const std::string& path);

}  // namespace ideotype
