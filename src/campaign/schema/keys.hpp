// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ideotype {

//! A key of a campaign or crop file as docs/campaign_files.md declares it,
//! whose tables the program has with it.
struct KeyInfo {
    std::string section;  //!< "top", "site", ..., "crop file", ..., "leaf"
    std::string name;
    std::string type;  //!< "integer", "number", "local date", ...
    std::string unit;  //!< "-" if it has none
    //! The range "-90 .. 90", the texts that are allowed, words, or "-" if it
    //! has none.
    std::string range;
    std::string initial;  //!< the default in TOML or words, or "required"
    std::string meaning;
    std::string example;             //!< as TOML, if messages need one
    double lower = 0, upper = 0;     //!< limits of numbers; none if equal
    std::vector<std::string> texts;  //!< that are allowed; none: any

    bool is_required() const { return initial == "required"; }
};

//! Returns every key in the order of a resolved campaign, crop files last.
const std::vector<KeyInfo>& campaign_keys();

//! Returns the declaration of a key.
//! @throws Error if the documentation has none, so that nobody can write a key
//! that it does not tell.
const KeyInfo& key_info(const std::string& section, const std::string& name);

}  // namespace ideotype
