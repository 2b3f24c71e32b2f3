// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/core/error.hpp"

namespace ideotype {

//! A name of an earlier version that stands in a campaign or crop file.
struct OldName {
    Location where;
    std::string what;  //!< "key 'inclination' in [leaf]"
    std::string was;
    std::string is;
    bool is_both = false;  //!< its table has the new name too
    std::string value;     //!< that it has today, as TOML; "": the same
    std::string also;      //!< an entry that goes with it today, as TOML
};

//! A campaign or crop file with the names of this version.
struct Migration {
    std::string file;
    std::string text;
    std::vector<OldName> changes;  //!< in the order of the text
    std::string plant_file;  //!< that the campaign names, as seen from here; ""
};

//! Gives the keys and values of a campaign or plant of an earlier version their
//! names of today; all other bytes stay as they are. The campaign of a history
//! of format 1.0 is read by `parse_campaign(migrated(text, file).text, file)`.
//! @param file is used in messages and to find the plant
//! @throws InputError if the text is not valid TOML
Migration migrated(const std::string& text, const std::string& file);

//! The same of a file, and then of the crop file that it names if there is
//! one.
//! @throws InputError if a file is not valid TOML
//! @throws Error if the file cannot be read
std::vector<Migration> read_migrations(const std::string& path);

}  // namespace ideotype
