// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "file_lock.hpp"
#include "handle.hpp"
#include "history.hpp"

namespace ideotype {

//! Creates a history with everything that it will ever contain. Under its own
//! name it is complete or does not exist. @throws Error, Hdf5Error
//! @param lock FileLock::of_new() of this path
void create_file(const std::string& path, const HistoryHeader& header,
                 const FileLock& lock);

//! Waits until the disk has a closed file or folder.
void synchronize_path(const std::filesystem::path& path);

//! Gives a complete file the name of another, which it replaces if it exists;
//! at no time is there neither.
void put_in_place(const std::string& from, const std::string& to);

//! Opens as the only writer, whatever a killed writer left behind. The caller
//! holds the FileLock. @throws Error (refused) if it is not a history.
Handle open_to_write(const std::string& path);

//! Opens a live, closed or killed history. @throws Error (refused) if it is not
//! a history, or of another major format version.
Handle open_as_it_is(const std::string& path);

//! Does the same if all that is recorded has its checksum.
Handle open_to_read(const std::string& path);

//! Does the same, but compares only the checksum of the header.
Handle open_to_read_header(const std::string& path);

//! A file that may be shorter than it was.
struct Remains {
    Handle file;
    std::uint64_t bytes = 0;    //!< that are there
    std::uint64_t missing = 0;  //!< bytes at the end
};

//! Opens also a history that was cut short: it reads as zeros beyond its end.
//! @throws Error (refused) if it is not a history or too little is left.
Remains open_remains(const std::string& path);

//! Hands all writes to the operating system: they survive SIGKILL.
void flush(hid_t file);

//! Waits until the disk has all writes: they survive a power failure.
void synchronize(hid_t file);

//! The system's descriptor of an open file.
int descriptor_of(hid_t file);

}  // namespace ideotype
