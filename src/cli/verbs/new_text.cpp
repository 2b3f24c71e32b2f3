// SPDX-License-Identifier: Apache-2.0
#include "new_text.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "campaign/problems.hpp"
#include "campaign/schema/keys.hpp"
#include "cli/texts.hpp"
#include "ideotype/climate/light_series.hpp"

namespace ideotype {

namespace {

//! Returns a full hour as a time of TOML, where 24:00 does not exist.
std::string clock(double hour) {
    return hour < 24 ? fmt::format("{:02}:00:00", hour) : "\"24:00\"";
}

}  // namespace

std::string new_text(const Site& site, const Date& date, double row,
                     double plant, const std::string& baseline,
                     const std::string& bounds, const std::string& objective) {
    const Daylight day = daylight(site, date);
    if (!day.sunrise && !(day.elevation > 0))
        throw wrong_usage(
            "the sun does not rise on {} at a latitude of {} deg; choose "
            "another date",
            to_string(date), site.latitude);
    const bool has_night = day.sunrise && day.sunset;
    std::istringstream lines(fmt::format(
        fmt::runtime(campaign_form), fmt::arg("name", site.name),
        fmt::arg("latitude", site.latitude),
        fmt::arg("longitude", site.longitude),
        fmt::arg("utc_offset", site.utc_offset),
        fmt::arg("date", to_string(date)),
        fmt::arg("start", clock(has_night ? std::floor(*day.sunrise) : 0)),
        fmt::arg("end", clock(has_night ? std::ceil(*day.sunset) : 24)),
        fmt::arg("row", row), fmt::arg("plant", plant),
        fmt::arg("baseline", baseline), fmt::arg("bounds", bounds),
        fmt::arg("objective", objective)));
    std::string text, section = "top";
    for (std::string line, name; std::getline(lines, line);) {
        if (line.starts_with('[') || line.starts_with('#') || line.empty()) {
            if (line.starts_with('[')) section = line;
            std::erase_if(section, [](char c) { return c == '[' || c == ']'; });
            text += (line.starts_with('#') && !name.empty() ? "\n" : "") +
                    line + '\n';
            continue;
        }
        const std::size_t equals = line.find(" = "), note = line.find(" # ");
        std::istringstream names(line.substr(0, std::min(equals, note)));
        while (names >> name)
            for (const KeyInfo& key : campaign_keys())
                if (key.section == section && key.name == name)
                    text += fmt::format(
                        "{:<27} # {}{}\n",
                        equals == line.npos ? name + " = " + key.initial
                                            : line.substr(0, note),
                        note == line.npos ? key.meaning : line.substr(note + 3),
                        key.unit == "-" ? "" : " [" + key.unit + "]");
    }
    return text;
}

}  // namespace ideotype
