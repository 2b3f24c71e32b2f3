// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ideotype {

//! The values that may be written for one key of a campaign or crop file, in
//! words.
struct KeyInfo {
    std::string section;  //!< "top", "site", ..., "crop file", ..., "leaf"
    std::string name;
    std::string type;     //!< "integer", "number", "local date", ...
    std::string unit;     //!< "-" if it has none
    std::string range;    //!< "-" if it has none
    std::string initial;  //!< the default in TOML, or "required"
    std::string meaning;
    double lower = 0, upper = 0;  //!< of numbers; the same: none
};

//! Every key in the order of a resolved campaign, crop files last.
std::vector<KeyInfo> campaign_keys();

}  // namespace ideotype
