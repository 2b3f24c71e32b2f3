// SPDX-License-Identifier: Apache-2.0
#include "new_answers.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <iostream>
#include <optional>
#include <unistd.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ideotype/campaign/campaign.hpp"
#include "ideotype/campaign/keys.hpp"
#include "ideotype/campaign/known_crops.hpp"
#include "ideotype/canopy/quantities.hpp"
#include "ideotype/core/csv.hpp"

namespace ideotype {

namespace {

[[noreturn]] void refuse(const std::string& what) {
    throw Error(what, ExitCode::usage);
}

//! @throws Error that names the nearest if a name is not one of these.
void require_known(const std::string& what, const std::string& name,
                   const std::vector<std::string>& names) {
    if (std::find(names.begin(), names.end(), name) != names.end()) return;
    refuse(fmt::format("there is no {} '{}'; {}", what, name,
                       did_you_mean(name, names)));
}

//! A goal that a newcomer may choose; the first is for who is unsure.
struct Goal {
    const char *objective, *meaning;
};
constexpr std::array<Goal, 4> goals{{
    {"carbon_balance",
     "the carbon that leaves take up less what they respire and are built of: "
     "leaf area\n     has its price (take this if unsure)"},
    {"net_assimilation",
     "the carbon that leaves take up less what they respire by day: leaf area "
     "costs little"},
    {"absorbed_par",
     "the light that leaves absorb: leaf area costs nothing, so expect much "
     "of it"},
    {"net_assimilation_per_leaf_area",
     "the same carbon per leaf area: few leaves, each in good light"},
}};

std::string goal_text() {
    std::string text = "What plants are bred for:\n";
    for (std::size_t i = 0; i < goals.size(); ++i)
        text += fmt::format("  {}  {}\n     {}\n", i + 1, goals[i].objective,
                            goals[i].meaning);
    return text + "Number or name";
}

//! The objective of a number in the list of goals, or the text as it is.
std::string to_objective(const std::string& text) {
    for (std::size_t i = 0; i < goals.size(); ++i)
        if (text == std::to_string(i + 1)) return goals[i].objective;
    return text;
}

void check_plant(const std::string& plant) {
    if (is_file(plant))
        read_crop(plant);
    else
        require_known("crop (and no file)", plant, known_crop_names());
}

//! Something that has to be told.
struct Question {
    std::string option;
    std::string text;                 //!< on a terminal
    std::string NewOptions::*answer;  //!< "": not given
    std::string initial;              //!< "": none
    std::function<void(const std::string&)> check;
};

std::vector<Question> questions() {
    const auto number = [](const char* section, const char* key) {
        return [=](const std::string& text) { to_number(text, section, key); };
    };
    return {
        {"--latitude", "Latitude of the place, north is positive [deg]",
         &NewOptions::latitude, "", number("site", "latitude")},
        {"--longitude", "Longitude, east is positive [deg]",
         &NewOptions::longitude, "", number("site", "longitude")},
        {"--date", "Date of a clear day, as 2025-07-01", &NewOptions::date, "",
         to_date},
        {"--row", "Distance between rows [m]", &NewOptions::row, "",
         number("spacing", "row")},
        {"--plant-spacing", "Distance between plants in a row [m]",
         &NewOptions::plant_spacing, "", number("spacing", "plant")},
        {"--plant",
         fmt::format("Plant: {}, a crop file (.toml) or measured leaves (.csv)",
                     fmt::join(known_crop_names(), ", ")),
         &NewOptions::plant, known_crop_names().front(), check_plant},
        {"--objective", goal_text(), &NewOptions::objective,
         goals.front().objective, [](const std::string& text) {
             require_known("objective", to_objective(text), objective_names());
         }}};
}

std::string ask(const Question& question) {
    for (;;) {
        fmt::print(
            "{}{}: ", question.text,
            question.initial.empty() ? "" : " (" + question.initial + ")");
        std::fflush(stdout);
        std::string answer;
        if (!std::getline(std::cin, answer))
            refuse(fmt::format("new: the input ended before {} was told",
                               question.option));
        if (answer.empty()) answer = question.initial;
        try {
            question.check(answer);
            return answer;
        } catch (const Error& error) {
            fmt::print("{}\n", error.what());
        }
    }
}

}  // namespace

double to_number(const std::string& text, const std::string& section,
                 const std::string& key) {
    const std::optional<double> number = number_of(text);
    for (const KeyInfo& info : campaign_keys())
        if (info.section == section && info.name == key &&
            (!number || *number < info.lower || *number > info.upper))
            refuse(
                fmt::format("\"{}\" is no {} (expected: a number, {} {}); "
                            "correct it",
                            text, key, info.range, info.unit));
    return number.value();
}

Date to_date(const std::string& text) {
    Date date;
    char more = 0;
    const int parts = std::sscanf(text.c_str(), "%4d-%2d-%2d%c", &date.year,
                                  &date.month, &date.day, &more);
    if (parts != 3 ||
        !std::chrono::year_month_day(
             std::chrono::year(date.year),
             std::chrono::month(static_cast<unsigned>(date.month)),
             std::chrono::day(static_cast<unsigned>(date.day)))
             .ok())
        refuse(
            fmt::format("\"{}\" is no date (year, month and day); write for "
                        "example 2025-07-01",
                        text));
    return date;
}

bool is_file(const std::string& plant) {
    return std::filesystem::path(plant).has_extension();
}

void complete(NewOptions& options) {
    std::vector<std::string> missing;
    for (const Question& each : questions()) {
        std::string& answer = options.*each.answer;
        if (!answer.empty()) {
            try {
                each.check(answer);
            } catch (const InputError&) {
                throw;
            } catch (const Error& error) {
                refuse(fmt::format("new: {}: {}", each.option, error.what()));
            }
        } else if (isatty(STDIN_FILENO) == 1) {
            answer = ask(each);
        } else if (each.initial.empty() || each.option == "--plant") {
            missing.push_back(each.option);
        } else {
            answer = each.initial;
        }
    }
    options.objective = to_objective(options.objective);
    if (!missing.empty())
        refuse(fmt::format(
            "new: there is no {} (on a terminal you would be asked); "
            "give {}",
            fmt::join(missing, ", "), missing.size() == 1 ? "it" : "them"));
}

}  // namespace ideotype
