// SPDX-License-Identifier: Apache-2.0
#include "cli/commands/new_answers.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <unistd.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/campaign.hpp"
#include "ideotype/canopy/quantities.hpp"
#include "ideotype/climate/weather.hpp"
#include "ideotype/core/text.hpp"
#include "spec/files.hpp"
#include "spec/problems.hpp"
#include "spec/section.hpp"
#include "spec/tables.hpp"
#include "spec/writer.hpp"

namespace ideotype {

namespace {

namespace fs = std::filesystem;

//! The consequence if an option is missing.
enum class Missing { asks, asks_or_default, is_default };

//! A question about the value of a key.
struct Question {
    const char *option, *section, *key;
    std::string text;
    std::string NewOptions::*answer;  //!< "" if not given
    //! Describes the fault of an answer; returns "" if there is none.
    //! @throws InputError if the answer names a file that contains problems.
    std::string (*fault)(const Question&, const std::string&);
    const char* initial = "";  //!< initial answer; "" if there is none
    Missing missing = Missing::asks;
};

struct Offer {
    const char *objective, *text;
};

constexpr Offer offers[] = {
    {usual_objective,
     "net carbon balance: carbon uptake less respiration and the "
     "construction\n     cost of leaves (choose this if unsure)"},
    {"net_assimilation",
     "carbon uptake of leaves less their daytime respiration: leaf area "
     "costs\n     little"},
    {"absorbed_par",
     "PAR absorbed by leaves: leaf area costs nothing, so expect a lot of it"},
    {"net_assimilation_per_leaf_area",
     "net assimilation per leaf area: few leaves, each in good light"}};

std::string question_of_objective() {
    std::string text = "Objective, the quantity to maximise:\n";
    for (const auto& [objective, meaning] : offers)
        text += fmt::format("  {}\n     {}\n", objective, meaning);
    return text + "Name";
}

std::string number_fault(const Question& question, const std::string& answer) {
    const std::optional<double> number = parse_number(answer);
    const Key& key = *find_key(question.section, question.key);
    if (!number)
        return fmt::format(
            "\"{}\" is not a valid {} (expected: a number, {}); correct it",
            answer, question.key, range_text(key));
    return fault_of(*number, question.section, key);
}

std::string date_fault(const Question& /*question*/,
                       const std::string& answer) {
    if (to_date(answer)) return "";
    return fmt::format(
        "\"{}\" is not a date (year, month and day); write for example "
        "2025-07-01",
        answer);
}

std::string weather_fault(const Question& /*question*/,
                          const std::string& answer) {
    try {
        describe_weather(read_text(answer), answer, Site{});
    } catch (const InputError&) {
        throw;
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

std::string plant_fault(const Question& /*question*/,
                        const std::string& answer) {
    if (is_file(answer)) {
        read_crop(answer);
        return "";
    }
    const std::vector<std::string> names = known_crop_names();
    if (std::ranges::count(names, answer) > 0) return "";
    constexpr std::pair<const char*, const char*> other_names[] = {
        {"corn", "maize"}, {"milo", "sorghum"}, {"soya", "soybean"}};
    std::string advice = did_you_mean(answer, names);
    for (const auto& [other, name] : other_names)
        if (lower_case(answer) == other)
            advice = fmt::format("did you mean '{}'?", name);
    return fmt::format("there is no crop (and no file) '{}'; {}", answer,
                       advice);
}

std::string objective_fault(const Question& /*question*/,
                            const std::string& answer) {
    const std::vector<std::string> names = objective_names();
    if (std::ranges::count(names, answer) > 0) return "";
    const std::string near = nearest_name(answer, names);
    std::vector<std::string> offered;
    for (const Offer& each : offers) offered.push_back(each.objective);
    return fmt::format(
        "there is no objective '{}'; {}", answer,
        near.empty()
            ? fmt::format("use one of {}, or another quantity of those listed "
                          "in docs/campaign_files.md under [objective]",
                          fmt::join(offered, ", "))
            : "did you mean '" + near + "'?");
}

const std::vector<Question>& questions() {
    static const std::vector<Question> list{
        {"--latitude", "site", "latitude",
         "Latitude of the site, north is positive [deg]", &NewOptions::latitude,
         number_fault},
        {"--longitude", "site", "longitude",
         "Longitude, east is positive [deg]", &NewOptions::longitude,
         number_fault},
        {"--utc-offset", "site", "utc_offset", "", &NewOptions::utc_offset,
         number_fault, "", Missing::is_default},
        {"--weather", "climate", "file",
         "Weather file, hourly CSV (leave empty for a clear day)",
         &NewOptions::weather, weather_fault, "", Missing::asks_or_default},
        {"--date", "day", "date", "Date of a clear day, such as 2025-07-01",
         &NewOptions::date, date_fault},
        {"--row", "spacing", "row", "Distance between rows [m]",
         &NewOptions::row, number_fault},
        {"--plant-spacing", "spacing", "plant",
         "Distance between plants in a row [m]", &NewOptions::plant_spacing,
         number_fault},
        {"--plant", "plant", "baseline",
         "Plant: maize, sorghum, soybean, cowpea or a crop file (.toml)",
         &NewOptions::plant, plant_fault, "maize"},
        {"--objective", "objective", "maximise", question_of_objective(),
         &NewOptions::objective, objective_fault, usual_objective,
         Missing::asks_or_default}};
    return list;
}

//! Returns whether a campaign needs the answer: a weather file replaces the
//! date of a clear day.
bool is_needed(const Question& question, const NewOptions& options) {
    return question.answer != &NewOptions::date || options.weather.empty();
}

std::string ask(const Question& question) {
    const std::string initial = question.initial;
    for (std::string answer;;) {
        fmt::print("{}{}: ", question.text,
                   initial.empty() ? "" : " (" + initial + ")");
        std::fflush(stdout);
        if (!std::getline(std::cin, answer))
            throw wrong_usage(
                "new: the input ended before {} was given; answer the "
                "question, or give the option",
                question.option);
        if (answer.empty()) answer = initial;
        if (answer.empty() && question.missing != Missing::asks) return answer;
        std::string fault;
        try {
            fault = question.fault(question, answer);
        } catch (const Error& error) {
            fault = error.what();
        }
        if (fault.empty()) return answer;
        fmt::print("{}\n", fault);
    }
}

//! Collects the faults of given options.
struct Faults {
    std::vector<std::string> options;
    std::vector<Problem> files;

    void add(const Question& question, const std::string& answer) {
        try {
            const std::string fault = question.fault(question, answer);
            if (!fault.empty())
                options.push_back(
                    fmt::format("new: {}: {}", question.option, fault));
        } catch (const InputError& error) {
            std::ranges::copy(error.problems(), std::back_inserter(files));
        } catch (const Error& error) {
            options.push_back(
                fmt::format("new: {}: {}", question.option, error.what()));
        }
    }

    void throw_if_any() const {
        if (options.empty() && files.empty()) return;
        if (options.empty()) throw InputError(files);
        std::vector<std::string> lines = options;
        if (!files.empty()) lines.push_back(InputError(files).what());
        throw wrong_usage("{}", fmt::join(lines, "\n"));
    }
};

}  // namespace

bool is_file(const std::string& plant) {
    return fs::path(plant).has_extension();
}

double to_number(const std::string& answer) {
    if (const std::optional<double> number = parse_number(answer))
        return *number;
    throw wrong_usage("\"{}\" is not a number; correct it", answer);
}

Date date_of(const std::string& answer) {
    if (const std::optional<Date> date = to_date(answer)) return *date;
    throw wrong_usage("\"{}\" is not a date; correct it", answer);
}

void complete(NewOptions& options) {
    const bool can_ask = isatty(STDIN_FILENO) == 1;
    Faults faults;
    std::vector<std::string> missing;
    if (!options.weather.empty() && !options.date.empty())
        faults.options.push_back(
            "new: --date and --weather are both given (the days are those of "
            "the weather file); remove one of them");
    for (const Question& question : questions()) {
        std::string& answer = options.*question.answer;
        if (!answer.empty())
            faults.add(question, answer);
        else if (can_ask || !is_needed(question, options))
            continue;
        else if (question.missing == Missing::asks)
            missing.push_back(question.option);
        else
            answer = question.initial;
    }
    if (!missing.empty())
        faults.options.push_back(fmt::format(
            "new: missing {} (on a terminal you would be asked); give {}",
            fmt::join(missing, ", "), missing.size() == 1 ? "it" : "them"));
    faults.throw_if_any();
    for (const Question& question : questions())
        if ((options.*question.answer).empty() &&
            is_needed(question, options) && can_ask &&
            question.missing != Missing::is_default)
            options.*question.answer = ask(question);
}

}  // namespace ideotype
