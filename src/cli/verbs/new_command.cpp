// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <unistd.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/campaign.hpp"
#include "campaign/problems.hpp"
#include "campaign/reading/files.hpp"
#include "campaign/schema/keys.hpp"
#include "cli/formats/output_file.hpp"
#include "cli/verbs.hpp"
#include "ideotype/canopy/quantities.hpp"
#include "ideotype/climate/light_series.hpp"
#include "ideotype/core/file.hpp"
#include "ideotype/core/text.hpp"

namespace ideotype {

namespace {

namespace fs = std::filesystem;

//! A question whose answer becomes the value of a key of the new campaign.
struct Question {
    const char *option, *section, *key, *text;
    std::string NewOptions::*answer;  //!< "" if it is not given
    const char* initial = "";         //!< initial answer; "" if there is none
};

constexpr Question questions[] = {
    {"--latitude", "site", "latitude",
     "Latitude of the place, north is positive [deg]", &NewOptions::latitude},
    {"--longitude", "site", "longitude", "Longitude, east is positive [deg]",
     &NewOptions::longitude},
    {"--date", "day", "date", "Date of a clear day, as 2025-07-01",
     &NewOptions::date},
    {"--row", "spacing", "row", "Distance between rows [m]", &NewOptions::row},
    {"--plant-spacing", "spacing", "plant",
     "Distance between plants in a row [m]", &NewOptions::plant_spacing},
    {"--plant", "plant", "baseline",
     "Plant: maize, sorghum, soybean, cowpea, a crop file (.toml) or measured "
     "leaves (.csv)",
     &NewOptions::plant, "maize"},
    {"--objective", "objective", "maximise",
     R"(What plants are bred for:
  carbon_balance
     the carbon that leaves take up less what they respire and are built of:
     leaf area has its price (take this if unsure)
  net_assimilation
     the carbon that leaves take up less what they respire by day: leaf area
     costs little
  absorbed_par
     the light that leaves absorb: leaf area costs nothing, so expect much of it
  net_assimilation_per_leaf_area
     the same carbon per leaf area: few leaves, each in good light
Name)",
     &NewOptions::objective, "carbon_balance"}};

double to_number(const std::string& text, const std::string& section,
                 const std::string& key) {
    const std::optional<double> number = number_of(text);
    const KeyInfo& info = key_info(section, key);
    if (!number || *number < info.lower || *number > info.upper)
        throw wrong_usage(
            "\"{}\" is no {} (expected: a number, {} {}); correct it", text,
            key, info.range, info.unit);
    return *number;
}

Date date_of(const std::string& text) {
    if (const std::optional<Date> date = to_date(text)) return *date;
    throw wrong_usage(
        "\"{}\" is no date (year, month and day); write for example 2025-07-01",
        text);
}

//! Tells a file from a crop that the program knows by name.
bool is_file(const std::string& plant) {
    return fs::path(plant).has_extension();
}

//! Checks an answer by the documentation of its key.
//! @throws Error if the key may not have this answer.
void check(const Question& question, const std::string& answer) {
    const std::string key = question.key;
    const auto require = [&](const std::string& what,
                             const std::vector<std::string>& names) {
        if (std::ranges::count(names, answer) == 0)
            throw wrong_usage("there is no {} '{}'; {}", what, answer,
                              did_you_mean(answer, names));
    };
    if (key == "date")
        date_of(answer);
    else if (key == "maximise")
        require("objective", objective_names());
    else if (key != "baseline")
        to_number(answer, question.section, key);
    else if (is_file(answer))
        read_crop(answer);
    else
        require("crop (and no file)", known_crop_names());
}

std::string ask(const Question& question) {
    const std::string initial = question.initial;
    for (std::string answer;;) {
        fmt::print("{}{}: ", question.text,
                   initial.empty() ? "" : " (" + initial + ")");
        std::fflush(stdout);
        if (!std::getline(std::cin, answer))
            throw wrong_usage(
                "new: the input ended before {} was given; answer it, or give "
                "it as an option",
                question.option);
        if (answer.empty()) answer = initial;
        try {
            check(question, answer);
            return answer;
        } catch (const Error& error) {
            fmt::print("{}\n", error.what());
        }
    }
}

//! Checks the given answers, and asks for missing ones on a terminal.
void complete(NewOptions& options) {
    std::vector<std::string> missing;
    for (const Question& each : questions) {
        std::string& answer = options.*each.answer;
        if (answer.empty() && isatty(STDIN_FILENO) == 1)
            answer = ask(each);
        else if (answer.empty() && each.key == std::string("maximise"))
            answer = each.initial;
        else if (answer.empty())
            missing.push_back(each.option);
        else
            try {
                check(each, answer);
            } catch (const InputError&) {
                throw;
            } catch (const Error& error) {
                throw wrong_usage("new: {}: {}", each.option, error.what());
            }
    }
    if (!missing.empty())
        throw wrong_usage(
            "new: there is no {} (on a terminal you would be asked); give {}",
            fmt::join(missing, ", "), missing.size() == 1 ? "it" : "them");
}

void write(const std::string& path, const std::string& text) {
    OutputFile file(path);
    file.print("{}", text);
    file.finish();
}

//! Copies a built-in crop to a file that users can change; returns whether the
//! file is new.
bool place_crop(const std::string& crop, const std::string& path) {
    const std::string text = known_crop(crop).value();
    if (!fs::exists(path)) return write(path, text), true;
    if (read_file(path, most_input_bytes).text != text)
        throw Error(
            fmt::format("{0}: exists already and is not overwritten (it "
                        "is not the {1} of the program); take it as it "
                        "is by --plant {0}, or give it another name",
                        path, crop),
            ExitCode::refused);
    return false;
}

//! Returns a full hour as a time of TOML, where 24:00 does not exist.
std::string clock(double hour) {
    return hour < 24 ? fmt::format("{:02}:00:00", hour) : "\"24:00\"";
}

//! Returns the text of a campaign file with the most important keys, their
//! units and meanings. Light lasts from sunrise to sunset.
//! @param plant path of the plant from the folder of the campaign
//! @param bounds "\n" and a line of the table [plant], or ""
//! @throws Error if the sun does not rise.
std::string new_text(const NewOptions& options, const std::string& plant,
                     const std::string& bounds) {
    Site site;
    site.name = options.name.empty() ? fs::path(options.path).stem().string()
                                     : options.name;
    if (options.name.empty())
        for (char& c : site.name)
            if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-')
                c = '_';
    site.latitude = to_number(options.latitude, "site", "latitude");
    site.longitude = to_number(options.longitude, "site", "longitude");
    site.utc_offset = options.utc_offset.empty()
                          ? std::round(site.longitude / 15)  // degrees per hour
                          : to_number(options.utc_offset, "site", "utc_offset");
    const Date date = date_of(options.date);
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
        fmt::arg("row", to_number(options.row, "spacing", "row")),
        fmt::arg("plant", to_number(options.plant_spacing, "spacing", "plant")),
        fmt::arg("baseline", plant), fmt::arg("bounds", bounds),
        fmt::arg("objective", options.objective)));
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
        while (names >> name) {
            const KeyInfo& key = key_info(section, name);
            text += fmt::format(
                "{:<27} # {}{}\n",
                equals == line.npos ? name + " = " + key.initial
                                    : line.substr(0, note),
                note == line.npos ? key.meaning : line.substr(note + 3),
                key.unit == "-" ? "" : " [" + key.unit + "]");
        }
    }
    return text;
}

//! Returns the text of a campaign whose bounds include the baseline of a plant.
std::string text_for(const NewOptions& options, const std::string& plant) {
    const std::string file =
        fs::proximate(plant, fs::absolute(options.path).parent_path())
            .generic_string();
    std::string text = new_text(
        options, file,
        std::ranges::count(read_crop(plant).rules, "breedable") > 0
            ? "\nbounds = \"breedable\" # what a breeder could select: sizes "
              "and angles that change smoothly from leaf to leaf; \"traits\" "
              "frees each leaf"
            : "\nbounds # how far traits may move: as the crop file says");
    std::vector<Problem> outside;
    try {
        outside = read_campaign_text(text, options.path).outside_bounds;
    } catch (const InputError& error) {
        const std::string& problem = error.problems().front().what;
        if (!problem.starts_with("the objective")) throw;
        throw wrong_usage(
            "new writes no such campaign ({}); do so in a copy of "
            "campaigns/growing_season.toml or campaigns/agrivoltaic.toml",
            problem);
    }
    if (outside.empty()) return text;
    // The last problem ends with the bounds to write.
    const std::string& remedy = outside.back().what;
    return new_text(options, file, "") +
           "\n# How far traits may move: as the crop file says,"
           " but wide enough for the baseline.\n" +
           remedy.substr(remedy.find("\n[") + 1) + '\n';
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
    const bool is_new = is_known && place_crop(options.plant, plant);
    try {
        write(options.path, text_for(options, plant));
    } catch (...) {
        if (is_new) fs::remove(plant);
        throw;
    }
    if (is_new) fmt::print("{}\n", plant);
    fmt::print("{0}\nnext: ideotype check {0}\n", options.path);
    return ExitCode::ok;
}

}  // namespace ideotype
