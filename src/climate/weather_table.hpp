// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "ideotype/climate/sun.hpp"
#include "ideotype/climate/weather.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/text.hpp"

namespace ideotype {

//! An instant by some clock.
using ClockTime = std::chrono::local_seconds;

//! A time as it stands in a file.
struct WrittenTime {
    ClockTime time;
    std::optional<double> utc_offset;  //!< [h]
};

//! Returns the first instant of a date.
ClockTime midnight(const Date& date);

//! Returns the date at an instant.
Date date_at(ClockTime time);

//! Hours since midnight.
double hour_at(ClockTime time);

//! Returns the instant so many hours later, to the nearest second.
ClockTime later(ClockTime time, double hours);

//! Reads the columns of a time: one, a date, T or a blank, a clock time, and
//! perhaps Z or an offset like -06:00; two, date and clock time; four or five,
//! year, month, day, hour and minute. Dates are 2011-07-21, or in another
//! order, also with / or . or nothing between, clock times 13:30, 13:30:00,
//! 1330 or 24:00.
std::optional<WrittenTime> parse_time(const std::vector<CsvField>& parts,
                                      DateOrder order);

//! Collects what is wrong with a file, and what is doubtful about it.
class Findings {
  public:
    explicit Findings(std::string file) : file_(std::move(file)) {}

    //! Adds a problem. More than can be read are only counted.
    template <class... Args>
    void add(int line, int column, fmt::format_string<Args...> what,
             Args&&... args) {
        if (problems_.size() < 20)
            problems_.push_back(
                {{file_, line, column},
                 fmt::format(what, std::forward<Args>(args)...)});
        else
            ++left_out_;
    }

    //! @throws InputError if there are problems.
    void stop_if_any() const {
        if (problems_.empty()) return;
        std::vector<Problem> all = problems_;
        if (left_out_ > 0)
            all.push_back(
                {{file_}, fmt::format("{} more problems", left_out_)});
        throw InputError(std::move(all));
    }

    //! @throws InputError of one problem.
    template <class... Args>
    [[noreturn]] void stop(int line, int column,
                           fmt::format_string<Args...> what,
                           Args&&... args) const {
        throw InputError({{{file_, line, column},
                           fmt::format(what, std::forward<Args>(args)...)}});
    }

    //! Adds a doubt; those of the same text become one warning.
    void doubt(int line, const std::string& text, bool is_counted = true) {
        for (Doubt& each : doubts_)
            if (is_counted && each.text == text) {
                ++each.count;
                return;
            }
        doubts_.push_back({text, line, is_counted ? 1 : 0});
    }

    //! Returns "text (N times)" of each doubt, with the place of the first.
    std::vector<Problem> warnings() const {
        std::vector<Problem> all;
        for (const auto& [text, line, count] : doubts_)
            all.push_back({{file_, line, 1},
                           count == 0
                               ? text
                               : fmt::format("{} ({} time{})", text, count,
                                             count == 1 ? "" : "s")});
        return all;
    }

  private:
    struct Doubt {
        std::string text;
        int line;
        int count;  //!< 0 if there can be only one
    };
    std::string file_;
    std::vector<Problem> problems_;
    std::vector<Doubt> doubts_;
    int left_out_ = 0;
};

//! The values of a row in our units; nothing where one is not known.
struct WeatherValues {
    std::optional<double> global;            //!< [W m-2]
    std::optional<double> beam_normal;       //!< [W m-2]
    std::optional<double> diffuse;           //!< [W m-2]
    std::optional<double> diffuse_fraction;  //!< of global, 0 to 1
    std::optional<double> ppfd;              //!< as solar radiation [W m-2]
    std::optional<double> temperature;       //!< [deg C]
    std::optional<double> humidity;          //!< 0 to 1
    std::optional<double> wind;              //!< [m s-1]
    std::optional<double> pressure;          //!< [kPa]
    std::optional<double> longwave;          //!< [W m-2]

    //! Returns whether the light on the ground follows from its columns.
    bool lit() const { return global || (beam_normal && diffuse); }
};

//! A time step, which has a row of the file or lies between rows.
struct WeatherStep {
    int line = 0;  //!< line of its row, or of the row before it
    ClockTime middle;
    WeatherValues values{};
    SunPosition sun{};   //!< in the middle
    double highest = 0;  //!< elevation of the sun, begin, middle or end [deg]
};

//! The rows of a period in order.
struct WeatherTable {
    ColumnMap columns;
    std::vector<CsvField> header;  //!< names of the columns
    std::size_t header_line = 0;   //!< from 1
    std::vector<WeatherStep> rows{};
    double utc_offset = 0;  //!< offset from UTC of the clock [h]
    std::chrono::seconds step{3600};
    //! True if the global light, or else the beam, is told in photons.
    bool counts_photons = false;
    //! The ends of a period: its first and last midnight; else the first and
    //! last rows.
    ClockTime begin{}, end{};

    //! Returns the index of the column of this name; adds a problem if there is
    //! not one.
    std::optional<std::size_t> index_of(const std::string& name,
                                        Findings& findings) const;
};

//! Reads head and rows of a period, without values.
//! @throws InputError if the file is no such table, of stamps that cannot be
//! read, of rows that are not in order, and if it does not have the period.
WeatherTable read_table(const std::vector<std::string_view>& lines,
                        const WeatherRequest& request, Findings& findings);

//! Reads the values of each of the rows, and whether light counts photons.
//! @throws InputError of columns, units and numbers that cannot be read.
void read_values(WeatherTable& table,
                 const std::vector<std::string_view>& lines,
                 double par_fraction, Findings& findings);

//! Returns all solar radiation on the ground [W m-2], of each step. Where
//! photons are counted, it is PAR over the fraction that the request gives.
//! @throws InputError if light is not known by day.
std::vector<Irradiance> light_of(const std::vector<WeatherStep>& series,
                                 Findings& findings);

//! Stops or warns if the light is hardly that of a site, whose clock is that
//! of the steps.
//! @throws InputError
void check_place(const std::vector<WeatherStep>& series,
                 const std::vector<Irradiance>& light, const Site& site,
                 Findings& findings);

//! Returns the entry of a row; an empty one if the row is too short.
inline CsvField entry(const std::vector<CsvField>& fields, std::size_t index) {
    return index < fields.size() ? fields[index]
                                 : CsvField{{}, fields.back().column};
}

}  // namespace ideotype
