// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "spec/problems.hpp"
#include "spec/spec.hpp"

namespace ideotype {

//! The kinds of text from which a campaign is read.
enum class TextSource {
    file,      //!< text as users write it, which may name files
    resolved,  //!< canonical text, without files
    history,   //!< canonical text of a history, perhaps of another version
};

//! Reads the text of a campaign and the crop files that it names. Values are
//! checked one by one, not against each other.
//! @param settings settings from the command line, see apply_settings()
//! @param is_study whether a sensitivity study is wanted; resolved texts state
//! it themselves
Spec read_spec(const std::string& text, const std::string& file,
               TextSource source, const std::vector<std::string>& settings,
               bool is_study, const Problems& problems);

//! Reads a resolved text; keys that this version lacks are ignored.
Spec read_resolved(const std::string& text);

//! Returns a warning about the keys in Spec::passed_over.
std::string passed_over_text(const std::set<std::string>& keys);

//! Reads the text of a crop file. Returns nothing if the text is a campaign.
std::optional<CropSpec> read_crop_spec(const std::string& text,
                                       const std::string& file,
                                       const Problems& problems);

}  // namespace ideotype
