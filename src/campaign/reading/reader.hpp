// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "campaign/draft.hpp"
#include "campaign/problems.hpp"
#include "campaign/schema/schema.hpp"
#include "crop_reader.hpp"

namespace ideotype {

//! Reads the text of a campaign, and the crop file that it names, into a
//! draft: everything but the checks of values against each other.
//! @param settings from the command line, see apply_settings()
void read_draft(const std::string& text, const std::string& file,
                PlantSource source, const std::vector<std::string>& settings,
                Draft& draft, const Problems& problems);

//! Reads the text of a crop file into a draft, in which all else stays as it
//! is. Returns false if it is the text of something else.
bool read_plant_draft(const std::string& text, const std::string& file,
                      Draft& draft, const Problems& problems);

//! Reads a table of measured leaves into a draft, whose plant tells the rest if
//! the table names no crop.
void read_measured_draft(const std::string& text, const std::string& file,
                         Draft& draft, const Problems& problems);

//! Reads the text of a file that has these tables and nothing else.
void read_tables(const std::string& text, const std::string& file,
                 const std::vector<Table>& all, const Problems& problems);

}  // namespace ideotype
