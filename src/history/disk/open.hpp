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

//! Reads the header from write_header(), and the form of outcomes from the
//! tables of rows.
HistoryHeader read_header(hid_t file);

//! Creates a history with all its datasets. Under its final name the file is
//! complete or does not exist. @throws Error, Hdf5Error
//! @param lock lock from FileLock::create_new() for this path
void create_file(const std::string& path, const HistoryHeader& header,
                 const FileLock& lock);

//! Returns the properties for opening and creating files.
Handle access_properties();

//! Opens a file as its only writer, also after the last writer was killed. The
//! caller holds the FileLock. @throws Error (refused) if it is not a history.
Handle open_to_write(const std::string& path);

//! Opens a live, closed or killed history for reading. @throws Error (refused)
//! if it is not a history, or has another major format version.
Handle open_as_it_is(const std::string& path);

//! A file that may have been truncated.
struct Remains {
    Handle file;
    std::uint64_t bytes = 0;    //!< bytes that still exist
    std::uint64_t missing = 0;  //!< bytes lost at the end
};

//! Opens a history that may be truncated: it reads as zeros beyond its end.
//! @throws Error (refused) if the file is not a history or too little of it is
//! left.
Remains open_remains(const std::string& path);

//! Passes all writes to the operating system: they survive SIGKILL.
void flush(hid_t file);

//! Waits until all writes are on the disk: they survive a power failure.
void synchronize(hid_t file);

//! Returns the system's descriptor of an open file.
int get_descriptor(hid_t file);

//! Reserves disk space for the whole file, so that no later write fails on a
//! full disk; checks the free space where the file system cannot reserve.
//! @throws Error with the space needed and free, and the given advice
//! @param path name of the file for the user
void reserve_space(hid_t file, const std::string& path,
                   const std::string& advice);

//! Requires free disk space. @throws Error like reserve_space() if fewer bytes
//! are free.
void require_room(const std::string& path, std::uint64_t bytes,
                  const std::string& advice);

//! Returns whether the file has no holes and all the space it will ever need.
bool has_all_room(hid_t file);

//! Returns "12.3 MiB are needed and 0.5 MiB are free", or "" if the file has
//! all the space it will ever need.
std::string lacking_space(const std::string& path);

}  // namespace ideotype
