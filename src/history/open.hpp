#pragma once

#include <string>

#include "handle.hpp"
#include "ideotype/history/history.hpp"

namespace ideotype {

//! Creates a history with everything that it will ever contain. Under its own
//! name it is complete or does not exist. @throws Error, Hdf5Error
void create_file(const std::string& path, const HistoryHeader& header);

//! Opens as the only writer, whatever a killed writer left behind. The caller
//! holds the FileLock. @throws Error (refused) if it is not a history.
Handle open_to_write(const std::string& path);

//! Opens a live, closed or killed history. @throws Error (refused) if it is
//! not a history.
Handle open_to_read(const std::string& path);

//! Hands all writes to the operating system: they survive SIGKILL.
void flush(hid_t file);

//! Waits until the disk has all writes: they survive a power failure.
void synchronize(hid_t file);

}  // namespace ideotype
