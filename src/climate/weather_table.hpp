// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ideotype/climate/sun.hpp"
#include "ideotype/climate/weather.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/text.hpp"

namespace ideotype {

//! An instant on the clock of a file or a site.
using ClockTime = std::chrono::local_seconds;

//! A time as the file gives it.
struct WrittenTime {
    ClockTime time;
    std::optional<double> utc_offset;  //!< offset of the clock [h]
};

//! Returns the first instant of a date.
ClockTime midnight(const Date& date);

//! Returns the date at an instant.
Date date_at(ClockTime time);

//! Returns the hours since midnight at an instant.
double hour_at(ClockTime time);

//! Returns the instant a number of hours later, to the nearest second.
ClockTime later(ClockTime time, double hours);

//! Parses a time from one column (date, T or a blank, clock time, and
//! optionally Z or an offset such as -06:00), two (date, clock time), or four
//! or five (year, month, day, hour, minute). Dates are 2011-07-21, or in
//! another order, also with / or . or no separator; clock times are 13:30,
//! 13:30:00, 1330 or 24:00.
std::optional<WrittenTime> parse_time(const std::vector<CsvField>& parts,
                                      DateOrder order);

//! Collects problems with a file, after which it cannot be used, and doubts,
//! which become warnings.
class Findings {
  public:
    explicit Findings(std::string file) : file_(std::move(file)) {}

    //! Adds a problem of the whole file or of a column.
    template <class... Args>
    void add(int line, int column, fmt::format_string<Args...> message,
             Args&&... args) {
        problems_.push_back(
            {{{file_, line, column},
              "",
              ProblemCode::data,
              fmt::format(message, std::forward<Args>(args)...)}});
    }

    //! Adds a problem of a row. Problems with the same format and column are
    //! merged and counted.
    //! @param field index of the faulty column; 0 if the whole row is at fault
    template <class... Args>
    void add_row(std::size_t field, int line, int column,
                 fmt::format_string<Args...> message, Args&&... args) {
        const fmt::string_view format = message;
        const Kind kind{{format.data(), format.size()}, field};
        for (Listed& listed : problems_)
            if (listed.kind == kind) {
                listed.lines.push_back(line);
                return;
            }
        add(line, column, message, std::forward<Args>(args)...);
        problems_.back().kind = kind;
    }

    //! @throws InputError if any problem has been added.
    void stop_if_any() const {
        if (problems_.empty()) return;
        std::vector<Problem> merged;
        for (const auto& [problem, kind, lines] : problems_) {
            merged.push_back(problem);
            constexpr std::size_t few = 5;
            if (lines.size() > few)
                merged.back().what +=
                    fmt::format(" (this line and {} others)", lines.size());
            else if (!lines.empty())
                merged.back().what += fmt::format(" (line{} {} too)",
                                                  lines.size() == 1 ? "" : "s",
                                                  fmt::join(lines, ", "));
        }
        throw InputError(std::move(merged));
    }

    //! @throws InputError with one problem.
    template <class... Args>
    [[noreturn]] void stop(int line, int column,
                           fmt::format_string<Args...> message,
                           Args&&... args) const {
        throw InputError({{{file_, line, column},
                           "",
                           ProblemCode::data,
                           fmt::format(message, std::forward<Args>(args)...)}});
    }

    //! Adds a doubt; doubts with equal texts are merged into one warning.
    void doubt(int line, const std::string& text, bool is_counted = true) {
        for (Doubt& known : doubts_)
            if (is_counted && known.text == text) {
                ++known.count;
                return;
            }
        doubts_.push_back({text, line, is_counted ? 1 : 0});
    }

    //! Returns "text (N times)" for each different doubt, with the location
    //! where it first occurred.
    std::vector<Problem> warnings() const {
        std::vector<Problem> warnings;
        for (const auto& [text, line, count] : doubts_)
            warnings.push_back({{file_, line, 1},
                                "",
                                ProblemCode::doubt,
                                count == 0
                                    ? text
                                    : fmt::format("{} ({} time{})", text, count,
                                                  count == 1 ? "" : "s")});
        return warnings;
    }

  private:
    struct Doubt {
        std::string text;
        int line;
        int count;  //!< number of occurrences; 0 if there can be only one
    };
    //! The format of a message, and the index of a column.
    using Kind = std::pair<std::string_view, std::size_t>;
    struct Listed {
        Problem problem;
        Kind kind{};
        std::vector<int> lines{};  //!< lines of later problems of the same kind
    };
    std::string file_;
    std::vector<Listed> problems_;
    std::vector<Doubt> doubts_;
};

//! The values of a row in the program's units; empty if unknown.
struct WeatherValues {
    std::optional<double> global;       //!< all solar radiation [W m-2]
    std::optional<double> beam_normal;  //!< on a plane facing the sun [W m-2]
    std::optional<double> diffuse;      //!< diffuse light [W m-2]
    //! Diffuse part of global light, 0 to 1.
    std::optional<double> diffuse_fraction;
    std::optional<double> ppfd;         //!< photons as solar radiation [W m-2]
    std::optional<double> temperature;  //!< air temperature [deg C]
    std::optional<double> humidity;     //!< relative humidity, 0 to 1
    std::optional<double> wind;         //!< speed [m s-1]
    std::optional<double> pressure;     //!< air pressure [kPa]
    std::optional<double> longwave;     //!< radiation of the sky [W m-2]
    std::optional<double> rain;         //!< rain during the step [mm]

    //! Returns whether the values suffice to compute the light on the ground.
    bool lit() const { return global || (beam_normal && diffuse); }
};

//! A time step, which may lack a row in the file.
struct WeatherStep {
    int line = 0;  //!< line of its row, or of the previous row
    ClockTime middle;
    WeatherValues values{};
    SunPosition sun{};   //!< sun in the middle of the step
    double highest = 0;  //!< highest sun during the step [deg]
};

//! The rows of a period in order.
struct WeatherTable {
    ColumnMap columns;
    std::vector<CsvField> header;  //!< names of the columns of the file
    std::size_t header_line = 0;   //!< line of the names, from 1
    std::vector<WeatherStep> rows{};
    double utc_offset = 0;  //!< offset from UTC of the clock [h]
    std::chrono::seconds step{3600};
    //! Whether global light (or the beam, if there is none) is given in
    //! photons.
    bool counts_photons = false;
    //! First and last midnight of the period, by default of the rows.
    ClockTime begin{}, end{};

    //! Returns the part of a step that its time stamp marks.
    Stamp stamp() const { return columns.stamp.value_or(Stamp::end); }

    //! Returns the column with a name; adds a problem if there is none or
    //! several.
    std::optional<std::size_t> find_column(const std::string& name,
                                           Findings& findings) const;
};

//! Finds the order of day, month and year that reads all stamps without going
//! back in time; returns nothing if there is none. If there are several, it
//! returns the one with the shortest period: the others mistake days for
//! months.
//! @param stamps fields of the time stamp, for each row
std::optional<DateOrder> find_date_order(
    const std::vector<std::vector<CsvField>>& stamps);

//! Reads the header and all rows, except for their values.
//! @throws InputError if the file is not a weather table, if a stamp is
//! unreadable, or if rows are out of order.
WeatherTable read_table(const std::vector<std::string_view>& lines,
                        const WeatherRequest& request, Findings& findings);

//! Returns a table with the rows of a period, by default that of the file.
//! @throws InputError if the file does not cover the period.
WeatherTable select_period(const WeatherTable& table,
                           const std::optional<Period>& period,
                           Findings& findings);

//! Reads the values of each row, and determines whether light is given in
//! photons.
//! @throws InputError for unreadable columns, units and numbers.
void read_values(WeatherTable& table,
                 const std::vector<std::string_view>& lines,
                 double par_fraction, Findings& findings);

//! Splits the solar radiation of each step into beam and diffuse light on the
//! ground [W m-2]. Photons have been converted to energy with the requested
//! fraction of PAR.
//! @throws InputError if the light of a step by day is unknown.
std::vector<Irradiance> split_light(const std::vector<WeatherStep>& series,
                                    Findings& findings);

//! Checks that the light matches the sun at a site, and warns of a doubtful
//! match.
//! @param table rows of the file, and the part of a step that stamps mark
//! @throws InputError if the light cannot have been measured at the site.
void check_place(const WeatherTable& table,
                 const std::vector<WeatherStep>& series,
                 const std::vector<Irradiance>& light, const Site& site,
                 Findings& findings);

//! Returns a field of a row; an empty one if the row is too short.
inline CsvField entry(const std::vector<CsvField>& fields, std::size_t index) {
    return index < fields.size() ? fields[index]
                                 : CsvField{{}, fields.back().column};
}

}  // namespace ideotype
