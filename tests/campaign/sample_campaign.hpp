// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "campaign/campaign.hpp"

namespace ideotype {

//! Returns a small complete campaign with an inline plant of one leaf. `top` is
//! inserted before the first table, `more` is appended to the end.
inline std::string sample_text(const std::string& top = "",
                               const std::string& more = "",
                               const std::string& bounds = "\"paper\"") {
    return "name = \"sample\"\n" + top + R"(
[[site]]
name = "Ames"
latitude = 42.0
longitude = -93.6
utc_offset = -5
[[day]]
date = 2025-08-07
start = 07:00:00
end = 20:00:00
[[spacing]]
row = 0.762
plant = 0.1524
[plant]
bounds = )" +
           bounds + R"(
[plant.baseline]
name = "single"
[[plant.baseline.leaf]]
length = 0.8
width = 0.08
insertion_angle = 40
curvature = 60
azimuth = 90
insertion_height = 0.2
)" + more;
}

inline Campaign sample(const std::string& top = "",
                       const std::string& more = "",
                       const std::string& bounds = "\"paper\"") {
    return parse_campaign(sample_text(top, more, bounds), "sample.toml");
}

inline Campaign ames() {
    return read_campaign(IDEOTYPE_CAMPAIGNS "/ames.toml");
}

//! Returns the text with the first occurrence of `old` replaced.
inline std::string replaced(std::string text, const std::string& old,
                            const std::string& to) {
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return text.replace(at, old.size(), to);
}

//! Returns the error message for the text of a campaign, or "" if it is valid.
inline std::string problem_of(const std::string& text) {
    try {
        parse_campaign(text, "sample.toml");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace ideotype
