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

//! Reads the header that write_header() wrote, and from the tables of rows the
//! form of outcomes.
HistoryHeader read_header(hid_t file);

//! Creates a history with everything that it will ever contain. Under its own
//! name it is complete or does not exist. @throws Error, Hdf5Error
//! @param lock FileLock::of_new() of this path
void create_file(const std::string& path, const HistoryHeader& header,
                 const FileLock& lock);

//! Returns how the program opens and creates files on the disk.
Handle access_properties();

//! Opens as the only writer, whatever a killed writer left behind. The caller
//! holds the FileLock. @throws Error (refused) if it is not a history.
Handle open_to_write(const std::string& path);

//! Opens a live, closed or killed history. @throws Error (refused) if it is not
//! a history, or of another major format version.
Handle open_as_it_is(const std::string& path);

//! A file that may be shorter than it was.
struct Remains {
    Handle file;
    std::uint64_t bytes = 0;    //!< bytes that are there
    std::uint64_t missing = 0;  //!< bytes at the end
};

//! Opens also a history that was cut short: it reads as zeros beyond its end.
//! @throws Error (refused) if it is not a history or too little is left.
Remains open_remains(const std::string& path);

//! Hands all writes to the operating system: they survive SIGKILL.
void flush(hid_t file);

//! Waits until the disk has all writes: they survive a power failure.
void synchronize(hid_t file);

//! Returns the system's descriptor of an open file.
int descriptor_of(hid_t file);

//! Takes room on the disk for the whole file, so that no later write can meet
//! a full one. Where the file system can't do that, looks whether there is
//! enough. path names the file to the user. @throws Error saying how much is
//! needed and how much is free, with this advice.
void reserve_space(hid_t file, const std::string& path,
                   const std::string& advice);

//! Requires room on a disk. @throws Error as reserve_space() does if fewer
//! bytes are free.
void require_room(const std::string& path, std::uint64_t bytes,
                  const std::string& advice);

//! Returns whether the file has all the room that it will ever need, and lacks
//! no byte.
bool has_all_room(hid_t file);

//! Returns "12.3 MiB are needed and 0.5 MiB are free", or nothing if the file
//! has all the room that it will ever need.
std::string lacking_space(const std::string& path);

}  // namespace ideotype
