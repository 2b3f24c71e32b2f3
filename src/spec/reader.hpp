// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "spec/problems.hpp"
#include "spec/spec.hpp"

namespace ideotype {

//! The kinds of campaign texts.
enum class TextSource {
    file,      //!< text that users write; it may name files
    resolved,  //!< canonical text, which names no files
    history,   //!< canonical text in a history, perhaps of another version
};

//! Reads the text of a campaign and the crop files that it names. Each value is
//! checked alone, not against other values.
//! @param settings settings from the command line, see apply_settings()
//! @param is_study whether a sensitivity study is requested; ignored for
//! resolved texts, which state this themselves
Spec read_spec(const std::string& text, const std::string& file,
               TextSource source, const std::vector<std::string>& settings,
               bool is_study, const Problems& problems);

//! Reads a resolved text. Keys that this version does not know are ignored.
Spec read_resolved(const std::string& text);

//! Returns a warning about the keys in Spec::passed_over.
std::string passed_over_text(const std::set<std::string>& keys);

//! Reads the text of a crop file. Returns nothing if the text is a campaign.
std::optional<CropSpec> read_crop_spec(const std::string& text,
                                       const std::string& file,
                                       const Problems& problems);

}  // namespace ideotype
