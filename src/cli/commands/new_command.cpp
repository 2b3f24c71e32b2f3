// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "campaign/campaign.hpp"
#include "cli/commands.hpp"
#include "cli/commands/new_answers.hpp"
#include "cli/formats/json_schema.hpp"
#include "cli/formats/output_file.hpp"
#include "ideotype/climate/light_series.hpp"
#include "ideotype/climate/weather.hpp"
#include "ideotype/core/file.hpp"
#include "spec/files.hpp"
#include "spec/problems.hpp"
#include "spec/tables.hpp"
#include "spec/writer.hpp"

namespace ideotype {

namespace {

namespace fs = std::filesystem;

void write(const std::string& path, const std::string& text) {
    OutputFile file(path);
    file.print("{}", text);
    file.finish();
}

//! Writes a built-in crop to a file that users can edit, unless the file
//! already contains it. Returns whether it was written.
bool place_crop(const std::string& crop, const std::string& path) {
    const std::string text = known_crop(crop).value();
    if (!fs::exists(path)) return write(path, text), true;
    if (read_file(path, most_input_bytes).text != text)
        throw Error(
            fmt::format(
                "{0}: exists already and is not overwritten (it differs from "
                "the built-in {1}); use it with --plant {0}, or rename it",
                path, crop),
            ExitCode::refused);
    return false;
}

//! Writes the JSON Schema of campaigns, with which editors complete and check
//! keys. A schema of another version is replaced. Returns whether the file is
//! new.
bool place_schema(const std::string& path) {
    const std::string text = campaign_schema_text();
    const bool is_new = !fs::exists(path);
    if (!is_new) {
        const std::string old = read_file(path, most_input_bytes).text;
        if (old == text) return false;
        if (!is_campaign_schema(old))
            throw Error(
                fmt::format("{}: exists already and is not overwritten (it is "
                            "not a JSON Schema of campaigns); rename it",
                            path),
                ExitCode::refused);
        fs::remove(path);
    }
    write(path, text);
    return is_new;
}

//! Formats a full hour as a TOML time. TOML has no time 24:00, so this is a
//! string.
std::string clock(double hour) {
    return hour < 24 ? fmt::format("{:02}:00:00", hour) : "\"24:00\"";
}

//! Returns the site of a new campaign.
Site site_of(const NewOptions& options) {
    Site site;
    site.name = options.name.empty() ? fs::path(options.path).stem().string()
                                     : options.name;
    if (options.name.empty())
        for (char& c : site.name)
            if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-')
                c = '_';
    site.latitude = to_number(options.latitude);
    site.longitude = to_number(options.longitude);
    site.utc_offset = options.utc_offset.empty()
                          ? std::round(site.longitude / 15)  // degrees per hour
                          : to_number(options.utc_offset);
    return site;
}

//! Returns a path relative to the folder of a campaign.
std::string path_beside(const std::string& campaign, const std::string& path) {
    return fs::proximate(path, fs::absolute(campaign).parent_path())
        .generic_string();
}

//! Returns the table of a clear day, which lasts from sunrise to sunset.
//! @throws Error if the sun does not rise.
std::string day_text(const Site& site, const Date& date) {
    const Daylight day = daylight(site, date);
    if (!day.sunrise && !(day.elevation > 0))
        throw wrong_usage(
            "the sun does not rise on {} at a latitude of {} deg; choose "
            "another date",
            to_string(date), site.latitude);
    const bool has_night = day.sunrise && day.sunset;
    return fmt::format(
        "# A clear day, from sunrise to sunset; for measured weather use "
        "--weather.\n[[day]]\ndate = {}\nstart = {}\nend = {}\nstep_minutes\n",
        to_string(date), clock(has_night ? std::floor(*day.sunrise) : 0),
        clock(has_night ? std::ceil(*day.sunset) : 24));
}

//! Returns the [[climate]] table for a weather file, with the columns that were
//! recognised.
std::string climate_text(const NewOptions& options, const Site& site) {
    const std::string& file = options.weather;
    const WeatherDescription weather =
        describe_weather(read_text(file), file, site);
    NamedClimate climate{"season", {}};
    climate.value.file = path_beside(options.path, file);
    climate.value.columns = weather.columns;
    climate.value.period = weather.period;
    if (!weather.columns.time.empty()) climate.value.stamp = "end";
    return "# A season of weather: all complete days of the file, with the "
           "columns as recognised.\n[[climate]]\n" +
           changed_keys(climate_table, &climate);
}

//! Returns a [field.variation] table with the within-line variation of the crop
//! file, or a comment that the variation is unknown.
std::string variation_text(const std::optional<CropVariation>& known) {
    if (!known)
        return "# The crop file has no [variation]: the within-line variation "
               "of this crop is\n# unknown, and plants differ only in azimuth. "
               "Gains are smaller in variable\n# stands.\n\n";
    const std::string lines = changed_keys(variation_table, &known->plants);
    return lines.empty() ? ""
                         : "# Within-line variation; the crop file states the "
                           "sources.\n[field.variation]\n" +
                               lines;
}

//! Returns the number of rows, or of plants per row, for each of several small
//! fields. Cells of 2 x 2 maize plants with a length of 0.30 m were tested
//! (tests/benchmark/stands.md). If plants are closer, more of them are needed
//! for the same length.
int count_in_cell(double distance) {
    constexpr double tested = 0.30;
    int count = 2;
    while (count * distance < tested - 1e-9) count += 2;
    return count;
}

//! Returns the text of a campaign file with the most important keys, their
//! units and their meanings.
//! @param bounds "\n" and a line of the table [plant], or ""
std::string new_text(const NewOptions& options, const Crop& crop,
                     const std::string& plant, const std::string& bounds) {
    const Site site = site_of(options);
    const double row = to_number(options.row);
    const double distance = to_number(options.plant_spacing);
    const auto jitter = crop.variation ? crop.variation->jitter : std::nullopt;
    // Fill in the template.
    std::istringstream lines(fmt::format(
        fmt::runtime(campaign_form), fmt::arg("name", site.name),
        fmt::arg("latitude", site.latitude),
        fmt::arg("longitude", site.longitude),
        fmt::arg("utc_offset", site.utc_offset),
        fmt::arg("light", options.weather.empty()
                              ? day_text(site, date_of(options.date))
                              : climate_text(options, site)),
        fmt::arg("row", row), fmt::arg("plant", distance),
        fmt::arg("rows", count_in_cell(row)),
        fmt::arg("plants", count_in_cell(distance)),
        fmt::arg("jitter", jitter ? fmt::format("jitter = {}\n", *jitter) : ""),
        fmt::arg("variation", variation_text(crop.variation)),
        fmt::arg("baseline", plant), fmt::arg("bounds", bounds),
        fmt::arg("objective", options.objective)));
    // Add default values, meanings and units to the keys of the text.
    std::string text, section = "top";
    bool is_after_key = false;
    for (std::string line, name; std::getline(lines, line);) {
        if (line.starts_with('[') || line.starts_with('#') || line.empty()) {
            if (line.starts_with('[')) section = line;
            std::erase_if(section, [](char c) { return c == '[' || c == ']'; });
            text += (line.starts_with('#') && is_after_key ? "\n" : "") + line +
                    '\n';
            is_after_key = false;
            continue;
        }
        is_after_key = true;
        const std::size_t equals = line.find(" = "), note = line.find(" # ");
        std::istringstream names(line.substr(0, std::min(equals, note)));
        while (names >> name) {
            const Key& key = *find_key(section, name);
            text += fmt::format(
                "{:<27} # {}{}\n",
                equals == line.npos ? name + " = " + default_of(section, key)
                                    : line.substr(0, note),
                note == line.npos ? key.meaning : line.substr(note + 3),
                *key.values.unit ? fmt::format(" [{}]", key.values.unit) : "");
        }
    }
    return text;
}

//! Returns the text of a campaign in which the bounds include the baseline.
std::string text_for(const NewOptions& options, const std::string& plant) {
    const Crop crop = read_crop(plant);
    const std::string file = path_beside(options.path, plant);
    const std::string text =
        new_text(options, crop, file,
                 std::ranges::count(crop.rules, "breedable") > 0
                     ? "\nbounds = \"breedable\" # traits that a breeder could "
                       "select: sizes and angles that change smoothly from "
                       "leaf to leaf; \"traits\" frees each leaf"
                     : "\nbounds # bounds of traits, from the crop file");
    const std::string wider =
        read_campaign_text(text, options.path).wider_bounds;
    if (wider.empty()) return text;
    return new_text(options, crop, file, "") +
           "\n# Bounds of traits, from the crop file, widened to include the "
           "baseline.\n" +
           wider + '\n';
}

//! Returns the text of a campaign after checking it. If an objective needs
//! tables that `new` does not write, the error says so.
std::string checked_text(const NewOptions& options, const std::string& plant) {
    try {
        return text_for(options, plant);
    } catch (const InputError& error) {
        const auto of_objective =
            std::ranges::find_if(error.problems(), [](const Problem& each) {
                return each.key.starts_with("objective.");
            });
        if (of_objective == error.problems().end()) throw;
        throw wrong_usage(
            "new cannot write a campaign for this objective ({}); edit a copy "
            "of campaigns/growing_season.toml or campaigns/agrivoltaic.toml",
            of_objective->what);
    }
}

}  // namespace

ExitCode write_new_campaign(const NewOptions& given) {
    NewOptions options = given;
    const fs::path beside = fs::path(options.path).parent_path();
    require_new(options.path);
    if (!beside.empty() && !fs::is_directory(beside))
        throw wrong_usage("new: there is no folder {}; make it first",
                          beside.string());
    complete(options);
    const bool is_known = !is_file(options.plant);
    const std::string plant =
        is_known ? (beside / (options.plant + ".toml")).string()
                 : options.plant;
    const std::string schema = (beside / "campaign.schema.json").string();
    std::vector<std::string> placed;
    try {
        if (is_known && place_crop(options.plant, plant))
            placed.push_back(plant);
        if (place_schema(schema)) placed.push_back(schema);
        write(options.path, checked_text(options, plant));
    } catch (...) {
        for (const std::string& path : placed) fs::remove(path);
        throw;
    }
    for (const std::string& path : placed) fmt::print("{}\n", path);
    fmt::print("{0}\nnext: ideotype check {0}\n", options.path);
    return ExitCode::ok;
}

}  // namespace ideotype
