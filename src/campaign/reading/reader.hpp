// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "campaign/draft.hpp"
#include "campaign/problems.hpp"
#include "campaign/schema/schema.hpp"
#include "crop_reader.hpp"

namespace ideotype {

//! Reads the text of a campaign, and the crop file that it names, into a draft,
//! without checks of values against each other.
//! @param settings settings from the command line, see apply_settings()
void read_draft(const std::string& text, const std::string& file,
                PlantSource source, const std::vector<std::string>& settings,
                Draft& draft, const Problems& problems);

//! Reads the text of a crop file into a draft and leaves all else in the draft
//! as it is. Returns false if the text is no crop file.
bool read_plant_draft(const std::string& text, const std::string& file,
                      Draft& draft, const Problems& problems);

//! Reads a table of measured leaves into a draft, whose plant has all other
//! values if the table names no crop.
void read_measured_draft(const std::string& text, const std::string& file,
                         Draft& draft, const Problems& problems);

//! Reads the text of a file that has the given tables and no others.
void read_tables(const std::string& text, const std::string& file,
                 const std::vector<Table>& all, const Problems& problems);

}  // namespace ideotype
