// SPDX-License-Identifier: Apache-2.0
#include "new_text.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "campaign/schema/keys.hpp"
#include "ideotype/climate/light_series.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype {

namespace {

//! The form of a campaign file. A key without value gets its default, and a key
//! without note its meaning.
constexpr auto campaign_form =
    R"(# A campaign of ideotype, a whole study in one file:
#     ideotype check FILE               what is wrong, size and cost
#     ideotype run FILE                 on all cores of this machine
# Other keys have defaults: see docs/campaign_files.md.

name = {name:?}
seed
replicates = 3 # searches of each case, apart but for their seeds: how far they differ is how sure a gain is
# The place and its clear sky.
[[site]]
name = {name:?}
latitude = {latitude}
longitude = {longitude}
utc_offset = {utc_offset} # local clock minus UTC; summer time is one more
elevation linke_turbidity
# A clear day, from sunrise to sunset. [[climate]] in its place takes measured weather.
[[day]]
date = {date}
start = {start}
end = {end}
step_minutes
# The distances between plants.
[[spacing]]
row = {row}
plant = {plant}
row_direction
# Plants that repeat without end.
[field]
rows = 2 # of each field; several small fields cost less than a large one, see light.fields
plants = 2 # of each row
boundary # "isolated" is a plot alone
# The differences between plants of a field, as measured; see docs/campaign_files.md.
[field.variation]
length = 0.05 # of each blade, relative
width = 0.06 # of each blade, relative
height = 0.04 # of the whole plant, relative
insertion_angle = 11 # of each leaf
curvature = 31 # of each leaf
azimuth = [21, 18, 28] # of leaves of the lower, middle and upper third
roll = [17, 17, 35] # of the same
twist = 86 # of each leaf
across_row = 0.7 # fraction of plants whose leaves point across the row
missing = 0.045 # fraction of plants
late = 0.04 # fraction of plants
# The plant that breeding begins with.
[plant]
baseline = {baseline:?} # crop file, from this folder{bounds}
# Parts of the light, in the PAR band; the plant tells its own.
[optics]
soil_albedo par_fraction
# The accuracy of an evaluation.
[light]
tolerance = 0.008 # relative standard error of the light that leaves absorb
paths # light paths per randomisation, at most
randomisations
fields = 4 # of each plant, one after the other: errors of rows contain how fields differ
sky # diffuse light; "overcast" and "clear" are others
# The objective of the search.
[objective]
maximise = {objective:?} # "net_assimilation", "absorbed_par" are others
# The optimizer that proposes plants.
[search]
optimizer = "auto" # "ga", "nsga2", "random" are others
# The first rule that holds ends a case.
[stop]
generations
no_gain # generations without a gain; 0: off, else 5 or more
# The best are evaluated again, with fresh random numbers.
[final]
candidates
paths = 4096 # light paths per randomisation
randomisations = 64 # each in a field of its own
)";

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
        throw Error(fmt::format("the sun does not rise on {} at a latitude of "
                                "{} deg; choose another date",
                                to_string(date), site.latitude),
                    ExitCode::usage);
    const bool has_night = day.sunrise && day.sunset;
    std::istringstream lines(fmt::format(
        campaign_form, fmt::arg("name", site.name),
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
