// SPDX-License-Identifier: Apache-2.0
#include "weather_times.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "ideotype/climate/daylight.hpp"
#include "weather_problems.hpp"

namespace ideotype {

namespace {

using namespace std::chrono;

//! The date in a year; nothing of a 29 February that it does not have.
std::optional<ClockTime> in_year(ClockTime time, int year) {
    const Date date = date_at(time);
    const auto day = midnight(year, date.month, date.day);
    if (!day) return std::nullopt;
    return *day + (time - floor<days>(time));
}

class TimesReader {
  public:
    TimesReader(const std::vector<std::string_view>& lines,
                const Layout& layout, const WeatherRequest& request)
        : lines_(lines),
          layout_(layout),
          request_(request),
          problems_(request.file) {}

    RowTimes read() {
        read_stamps();
        problems_.stop_if_any();
        if (result_.rows.size() < 2)
            problems_.stop(0, 0, "there are not two rows of data");
        find_step();
        const bool typical = is_typical();
        move_to_middle();
        choose_clock();
        if (typical) give_years();
        check_order();
        select_period();
        return std::move(result_);
    }

  private:
    void read_stamps() {
        std::vector<std::size_t> columns;
        for (const std::string& name : layout_.columns.time)
            if (const auto index = column_index(layout_, name, problems_))
                columns.push_back(*index);
        problems_.stop_if_any();
        std::optional<double> offset = layout_.columns.utc_offset;
        for (std::size_t i = layout_.first_row; i < lines_.size(); ++i) {
            if (lines_[i].find_first_not_of(" \t,") == std::string_view::npos)
                continue;
            const std::vector<CsvField> fields = fields_of(lines_[i]);
            std::vector<CsvField> parts;
            for (const std::size_t index : columns)
                parts.push_back(entry(fields, index));
            const int line = static_cast<int>(i) + 1;
            std::optional<WrittenTime> written = time_of(parts);
            if (!written) {
                std::vector<std::string_view> texts;
                for (const CsvField& each : parts) texts.push_back(each.text);
                problems_.add(line, parts.front().column,
                              fmt::format("\"{}\" is no date and time; check "
                                          "the order of day and month",
                                          fmt::join(texts, ",")));
                continue;
            }
            if (written->utc_offset) {
                // Summer time may come and go: one clock for all.
                if (!offset) offset = written->utc_offset;
                written->time =
                    later(written->time, *offset - *written->utc_offset);
            }
            result_.rows.push_back({line, written->time});
        }
        result_.utc_offset = offset.value_or(request_.site.utc_offset);
    }

    std::optional<WrittenTime> time_of(
        const std::vector<CsvField>& parts) const {
        const DateOrder order = layout_.columns.date_order;
        if (parts.size() == 1) return parse_time(parts[0].text, order);
        if (parts.size() == 2) {
            const auto date = parse_date(parts[0].text, order);
            const auto hours = parse_clock(parts[1].text);
            if (!date || !hours) return std::nullopt;
            return WrittenTime{later(*date, *hours), {}};
        }
        std::array<double, 5> numbers{};
        for (std::size_t i = 0; i < parts.size() && i < numbers.size(); ++i) {
            const auto number = number_of(parts[i].text);
            if (!number || !(std::abs(*number) <= 9999)) return std::nullopt;
            numbers[i] = *number;
        }
        const auto whole = [&](std::size_t i) {
            return static_cast<int>(numbers[i]);
        };
        for (std::size_t i = 0; i < 3; ++i)
            if (numbers[i] != whole(i)) return std::nullopt;
        const auto date = midnight(whole(0), whole(1), whole(2));
        double hours = numbers[3] + numbers[4] / 60;
        // The hour counts from 1, and its last step has the minute 60 or 0.
        if (layout_.hours == HourStyle::energy_plus && parts.size() == 5)
            hours = numbers[3] - 1 + (numbers[4] == 0 ? 1 : numbers[4] / 60);
        if (!date || hours < 0 || hours > 24) return std::nullopt;
        return WrittenTime{later(*date, hours), {}};
    }

    //! The most frequent difference between neighbours.
    void find_step() {
        std::map<seconds, int> count;
        for (std::size_t i = 1; i < result_.rows.size(); ++i)
            ++count[result_.rows[i].middle - result_.rows[i - 1].middle];
        const auto most = std::max_element(
            count.begin(), count.end(),
            [](const auto& a, const auto& b) { return a.second < b.second; });
        result_.step = most->first;
        if (result_.step < 1min || result_.step > 1h ||
            24h % result_.step != 0s) {
            problems_.stop(
                result_.rows[1].line, 1,
                fmt::format("the rows are {} s apart (there must be one each "
                            "hour, or a part of it that divides the day)",
                            result_.step.count()));
        }
    }

    //! Whether months of different years follow each other, as in a typical
    //! year that is put together from several.
    bool is_typical() const {
        if (!layout_.may_be_typical) return false;
        // The last stamp of a month may be midnight.
        const auto& rows = result_.rows;
        return std::adjacent_find(rows.begin(), rows.end(),
                                  [](const RowTime& a, const RowTime& b) {
                                      return abs(b.middle - a.middle) > 24h &&
                                             date_at(a.middle - 1s).year !=
                                                 date_at(b.middle - 1s).year;
                                  }) != rows.end();
    }

    void move_to_middle() {
        const Stamp stamp = layout_.columns.stamp;
        if (stamp == Stamp::middle) return;
        const seconds half = result_.step / 2;
        for (RowTime& row : result_.rows)
            row.middle += stamp == Stamp::beginning ? half : -half;
    }

    //! The site's clock where days of the file's would end by day.
    void choose_clock() {
        Site site = request_.site;
        site.utc_offset = result_.utc_offset;
        if (std::abs(clock_ahead(site)) <= 3) return;
        const double shift = request_.site.utc_offset - result_.utc_offset;
        for (RowTime& row : result_.rows) row.middle = later(row.middle, shift);
        result_.utc_offset = request_.site.utc_offset;
    }

    //! Puts a typical year's rows into the years of the period.
    void give_years() {
        const int first = date_at(result_.rows.front().middle).year;
        const Period period =
            request_.period.value_or(Period{{first, 1, 1}, {first, 12, 31}});
        const ClockTime begin = midnight(period.from);
        const ClockTime end = midnight(period.to) + 24h;
        if (end - begin > 366 * 24h)
            problems_.stop(0, 0,
                           "the period is longer than the year of the file "
                           "(a typical year)");
        std::vector<RowTime> rows;
        for (const RowTime& row : result_.rows)
            for (int year = period.from.year; year <= period.to.year; ++year)
                if (const auto time = in_year(row.middle, year);
                    time && *time >= begin && *time < end)
                    rows.push_back({row.line, *time});
        std::stable_sort(rows.begin(), rows.end(),
                         [](const RowTime& a, const RowTime& b) {
                             return a.middle < b.middle;
                         });
        result_.rows = std::move(rows);
    }

    void check_order() {
        for (std::size_t i = 1; i < result_.rows.size(); ++i) {
            const RowTime& row = result_.rows[i];
            const RowTime& before = result_.rows[i - 1];
            if (row.middle == before.middle)
                problems_.add(
                    row.line, 1,
                    fmt::format("the same time as on line {} (a duplicate, or "
                                "the end of summer time); leave one out, or "
                                "use a clock that is not changed",
                                before.line));
            else if (row.middle < before.middle)
                problems_.add(row.line, 1,
                              fmt::format("the time is before that of line {}; "
                                          "sort the rows",
                                          before.line));
        }
        problems_.stop_if_any();
    }

    void select_period() {
        auto& rows = result_.rows;
        if (!request_.period) {
            result_.begin = rows.front().middle;
            result_.end = rows.back().middle + result_.step;
            return;
        }
        const Period& period = *request_.period;
        result_.begin = midnight(period.from);
        result_.end = midnight(period.to) + 24h;
        if (result_.end <= result_.begin)
            problems_.stop(
                0, 0,
                fmt::format("the period ends on {}, before it "
                            "begins on {}",
                            to_string(period.to), to_string(period.from)));
        const bool has_all = !rows.empty() &&
                             rows.front().middle < result_.begin + 24h &&
                             rows.back().middle >= result_.end - 24h;
        if (!has_all)
            problems_.stop(
                0, 0,
                rows.empty()
                    ? "no row is of the period"
                    : fmt::format("the file has {} to {}, but the period is "
                                  "{} to {}; choose days that it has",
                                  to_string(date_at(rows.front().middle)),
                                  to_string(date_at(rows.back().middle)),
                                  to_string(period.from),
                                  to_string(period.to)));
        std::erase_if(rows, [&](const RowTime& row) {
            return row.middle < result_.begin || row.middle >= result_.end;
        });
        if (rows.empty()) problems_.stop(0, 0, "no row is of the period");
    }

    const std::vector<std::string_view>& lines_;
    const Layout& layout_;
    const WeatherRequest& request_;
    Problems problems_;
    RowTimes result_;
};

}  // namespace

RowTimes read_times(const std::vector<std::string_view>& lines,
                    const Layout& layout, const WeatherRequest& request) {
    return TimesReader(lines, layout, request).read();
}

}  // namespace ideotype
