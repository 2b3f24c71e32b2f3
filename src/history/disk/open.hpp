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

//! Writes root attributes, /campaign, /genes and /objectives.
void write_header(hid_t file, const HistoryHeader& header);

//! Reads the header from write_header(), and the form of outcomes from the
//! tables of rows.
HistoryHeader read_header(hid_t file);

//! Creates a history with all its datasets. Under its own name the file is
//! complete or does not exist. @throws Error, Hdf5Error
//! @param lock lock from FileLock::of_new() for this path
void create_file(const std::string& path, const HistoryHeader& header,
                 const FileLock& lock);

//! Returns the properties with which the program opens and creates files.
Handle access_properties();

//! Opens a file as the only writer, even after a kill of the last writer. The
//! caller holds the FileLock. @throws Error (refused) if it is no history.
Handle open_to_write(const std::string& path);

//! Opens a live, closed or killed history. @throws Error (refused) if it is no
//! history, or has another major format version.
Handle open_as_it_is(const std::string& path);

//! A file that may have been truncated.
struct Remains {
    Handle file;
    std::uint64_t bytes = 0;    //!< bytes that still exist
    std::uint64_t missing = 0;  //!< bytes lost at the end
};

//! Opens a history that may be truncated: it reads as zeros beyond its end.
//! @throws Error (refused) if the file is no history or too little of it is
//! left.
Remains open_remains(const std::string& path);

//! Hands all writes to the operating system: they survive SIGKILL.
void flush(hid_t file);

//! Waits until the disk has all writes: they survive a power failure.
void synchronize(hid_t file);

//! Returns the system's descriptor of an open file.
int descriptor_of(hid_t file);

//! Reserves room on the disk for the whole file, so that no later write fails
//! on a full disk, or checks the free room if the file system cannot reserve
//! it. path names the file to the user. @throws Error that tells needed and
//! free room, with the given advice.
void reserve_space(hid_t file, const std::string& path,
                   const std::string& advice);

//! Requires room on a disk. @throws Error as reserve_space() does if fewer
//! bytes are free.
void require_room(const std::string& path, std::uint64_t bytes,
                  const std::string& advice);

//! Returns whether the file has no holes and all room that it will ever need.
bool has_all_room(hid_t file);

//! Returns "12.3 MiB are needed and 0.5 MiB are free", or nothing if the file
//! has all the room that it will ever need.
std::string lacking_space(const std::string& path);

}  // namespace ideotype
