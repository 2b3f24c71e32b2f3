// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ideotype {

//! A key of a campaign or crop file as docs/campaign_files.md declares it; the
//! program contains the tables of this document.
struct KeyInfo {
    std::string section;  //!< "top", "site", ..., "crop file", ..., "leaf"
    std::string name;
    std::string type;  //!< type, "integer", "local date", ...
    std::string unit;  //!< unit; "-": none
    //! The range "-90 .. 90", the allowed texts, a description, or "-" if the
    //! key has no range.
    std::string range;
    std::string initial;  //!< default as TOML or in words, or "required"
    std::string meaning;
    std::string example;             //!< example as TOML for messages, or ""
    double lower = 0, upper = 0;     //!< limits; none if equal
    std::vector<std::string> texts;  //!< allowed texts; none: any

    bool is_required() const { return initial == "required"; }
};

//! Returns every key in the order of a resolved campaign, crop files last.
const std::vector<KeyInfo>& campaign_keys();

//! Returns the declaration of a key.
//! @throws Error if the documentation lacks the key.
const KeyInfo& key_info(const std::string& section, const std::string& name);

}  // namespace ideotype
