#pragma once

#include "handle.hpp"
#include "ideotype/history/history.hpp"

namespace ideotype {

inline constexpr const char* format_name = "ideotype-history";
inline constexpr const char* format_version = "1.0";

//! Writes root attributes, /campaign, /traits, /objectives and /diagnostics.
void write_header(hid_t file, const HistoryHeader& header);

//! Reads what write_header() wrote.
HistoryHeader read_header(hid_t file);

//! A string attribute of the root group, empty if there is none.
std::string text_attribute(hid_t file, const std::string& name);

}  // namespace ideotype
