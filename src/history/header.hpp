// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "handle.hpp"
#include "history.hpp"

namespace ideotype {

inline constexpr const char* format_name = "ideotype-history";
inline constexpr const char* format_version = "2.0";

//! Writes root attributes, /campaign, /genes and /objectives.
void write_header(hid_t file, const HistoryHeader& header);

//! Reads what write_header() wrote, and from the tables of rows what is
//! measured.
HistoryHeader read_header(hid_t file);

}  // namespace ideotype
