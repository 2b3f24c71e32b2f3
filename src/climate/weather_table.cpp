// SPDX-License-Identifier: Apache-2.0
#include "weather_table.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ideotype/climate/light_series.hpp"
#include "ideotype/core/mapped.hpp"

namespace ideotype {

namespace {

using namespace std::chrono;

bool has_column(const std::vector<CsvField>& header, std::string_view name) {
    return std::any_of(
        header.begin(), header.end(),
        [&](const CsvField& field) { return field.text == name; });
}

//! Maps those columns that `ideotype weather` writes and that the header
//! contains.
ColumnMap map_native_columns(ColumnMap columns,
                             const std::vector<CsvField>& header) {
    columns.time = {"time"};
    columns.stamp = columns.stamp.value_or(Stamp::middle);
    const auto add = [&](std::optional<Column>& column, const char* name,
                         const char* unit) {
        if (has_column(header, name)) column = Column{name, unit};
    };
    add(columns.global, "global", "W/m2");
    add(columns.beam_normal, "beam_normal", "W/m2");
    add(columns.diffuse, "diffuse", "W/m2");
    add(columns.temperature, "temperature", "C");
    add(columns.humidity, "humidity", "%");
    add(columns.wind, "wind", "m/s");
    add(columns.pressure, "pressure", "kPa");
    add(columns.longwave, "longwave", "W/m2");
    add(columns.rain, "rain", "mm/h");
    return columns;
}

//! Explains how to convert a file in another format, or how to map its columns.
std::string explain_conversion(const WeatherRequest& request) {
    const std::string& file = request.file;
    std::string command = fmt::format(
        "ideotype weather '{}' --to '{}_weather.csv' --latitude {} --longitude "
        "{} --utc-offset {}",
        file, std::filesystem::path(file).replace_extension().string(),
        request.site.latitude, request.site.longitude, request.site.utc_offset);
    if (request.period)
        command += fmt::format(" --from {} --until {}",
                               to_string(request.period->from),
                               to_string(request.period->to));
    return "this is not a table with columns time and global; map its columns "
           "in [[climate]], or convert it and name the file that this command "
           "writes: " +
           command;
}

//! Reads the header: the first line that contains the time column.
WeatherTable read_header(const std::vector<std::string_view>& lines,
                         const WeatherRequest& request, Findings& findings) {
    WeatherTable table{request.columns, {}};
    const bool is_native = request.columns.time.empty();
    const std::string time = is_native ? "time" : request.columns.time.front();
    for (std::size_t i = 0; i < std::min<std::size_t>(lines.size(), 100); ++i) {
        table.header = split_fields(lines[i]);
        table.header_line = i + 1;
        if (!has_column(table.header, time)) continue;
        if (!is_native) return table;
        table.columns = map_native_columns(request.columns, table.header);
        if (!table.columns.global && !table.columns.beam_normal) break;
        return table;
    }
    if (is_native) findings.stop(1, 1, "{}", explain_conversion(request));
    findings.stop(
        1, 1, "no line has a column \"{}\" (the header must name the columns)",
        time);
}

const char* get_name(DateOrder order) {
    switch (order) {
        case DateOrder::month_day_year:
            return "month_day_year";
        case DateOrder::day_month_year:
            return "day_month_year";
        default:
            return "year_month_day";
    }
}

//! Reads the time stamps of all rows, and converts them to one clock.
void read_stamps(WeatherTable& table,
                 const std::vector<std::string_view>& lines, double site_offset,
                 Findings& findings) {
    std::vector<std::size_t> columns;
    for (const std::string& name : table.columns.time)
        if (const auto index = table.find_column(name, findings))
            columns.push_back(*index);
    findings.stop_if_any();
    std::optional<double> offset = table.columns.utc_offset;
    std::vector<std::vector<CsvField>> stamps;
    std::vector<int> unreadable;
    for (std::size_t i = table.header_line; i < lines.size(); ++i) {
        if (lines[i].find_first_not_of(" \t,") == std::string_view::npos)
            continue;
        const std::vector<CsvField> fields = split_fields(lines[i]);
        const std::vector<CsvField>& parts = stamps.emplace_back(
            mapped(columns, [&](auto index) { return entry(fields, index); }));
        const int line = static_cast<int>(i) + 1;
        auto written = parse_time(parts, table.columns.date_order);
        table.rows.push_back({line, written ? written->time : ClockTime{}});
        if (!written) {
            unreadable.push_back(static_cast<int>(stamps.size()) - 1);
            continue;
        }
        if (written->utc_offset) {
            // Apply the offset of the first row to all rows, since summer time
            // may begin or end within the file.
            if (!offset) offset = written->utc_offset;
            table.rows.back().middle =
                later(written->time, *offset - *written->utc_offset);
        }
    }
    // Report unreadable stamps once, and suggest an order of day, month and
    // year that would read them.
    if (!unreadable.empty()) {
        const auto order = find_date_order(stamps);
        const std::string remedy =
            order ? fmt::format("set date_order = \"{}\"", get_name(*order))
                  : "correct it, or check date_order and the columns of time";
        for (const int row : unreadable) {
            const auto& parts = stamps[static_cast<std::size_t>(row)];
            findings.add_row(
                0, table.rows[static_cast<std::size_t>(row)].line,
                parts.front().column, "\"{}\" is not a date and time; {}",
                fmt::join(mapped(parts, &CsvField::text), ","), remedy);
        }
    }
    findings.stop_if_any();
    table.utc_offset = offset.value_or(site_offset);
    if (table.rows.size() < 2)
        findings.stop(0, 0, "there are fewer than two rows of data");
}

//! Sets the step to the most frequent difference between consecutive rows, and
//! moves stamps to the middles of steps.
void find_step(WeatherTable& table, Findings& findings) {
    auto& rows = table.rows;
    std::map<seconds, int> count;
    for (std::size_t i = 1; i < rows.size(); ++i)
        ++count[rows[i].middle - rows[i - 1].middle];
    const auto frequent = std::max_element(
        count.begin(), count.end(),
        [](const auto& a, const auto& b) { return a.second < b.second; });
    table.step = frequent->first;
    if (table.step < 1min || table.step > 1h || 24h % table.step != 0s)
        findings.stop(rows[1].line, 1,
                      "the rows are {} s apart (there must be one each hour, "
                      "or a part of it that divides the day)",
                      table.step.count());
    const Stamp stamp = table.stamp();
    if (stamp == Stamp::middle) return;
    const seconds half = table.step / 2;
    for (WeatherStep& row : rows)
        row.middle += stamp == Stamp::beginning ? half : -half;
}

//! Chooses the site's clock if the date on the file's clock would change during
//! daylight.
void choose_clock(WeatherTable& table, Site site) {
    const double shift = site.utc_offset - table.utc_offset;
    std::swap(site.utc_offset, table.utc_offset);
    if (std::abs(clock_ahead(site)) <= 3) {
        table.utc_offset = site.utc_offset;
        return;
    }
    for (WeatherStep& row : table.rows) row.middle = later(row.middle, shift);
}

//! Checks that rows are in order, without duplicates.
void check_order(const WeatherTable& table, Findings& findings) {
    for (std::size_t i = 1; i < table.rows.size(); ++i) {
        const WeatherStep& row = table.rows[i];
        const WeatherStep& before = table.rows[i - 1];
        if (row.middle == before.middle)
            findings.add_row(
                0, row.line, 1,
                "the same time as on line {} (a duplicate, or the end "
                "of summer time); leave one out, or use a clock that "
                "is not changed",
                before.line);
        else if (row.middle < before.middle)
            findings.add_row(
                0, row.line, 1,
                "the time is before that of line {}; sort the rows",
                before.line);
    }
    findings.stop_if_any();
}

}  // namespace

std::optional<std::size_t> WeatherTable::find_column(const std::string& name,
                                                     Findings& findings) const {
    const auto matches = [&](const CsvField& field) {
        return field.text == name;
    };
    const auto column = std::find_if(header.begin(), header.end(), matches);
    const int line = static_cast<int>(header_line);
    if (column == header.end()) {
        std::vector<std::string> names;
        for (const CsvField& field : header) names.emplace_back(field.text);
        const std::string near = nearest_name(name, names);
        findings.add(line, 1, "there is no column \"{}\"{}", name,
                     near.empty() ? "" : "; is it \"" + near + "\"?");
        return std::nullopt;
    }
    if (std::find_if(column + 1, header.end(), matches) != header.end())
        findings.add(line, column->column,
                     "two columns have the name \"{}\"; rename one of them",
                     name);
    return static_cast<std::size_t>(column - header.begin());
}

std::optional<DateOrder> find_date_order(
    const std::vector<std::vector<CsvField>>& stamps) {
    using enum DateOrder;
    std::optional<DateOrder> best;
    seconds shortest = seconds::max();
    for (const DateOrder order :
         {year_month_day, month_day_year, day_month_year}) {
        std::optional<ClockTime> first, last;
        // Accept an order if it reads all stamps and none goes back in time.
        const auto follows = [&](const std::vector<CsvField>& parts) {
            const auto written = parse_time(parts, order);
            if (!written || (last && written->time < *last)) return false;
            last = written->time;
            if (!first) first = last;
            return true;
        };
        if (!std::ranges::all_of(stamps, follows) || !first ||
            *last - *first >= shortest)
            continue;
        best = order;
        shortest = *last - *first;
    }
    return best;
}

WeatherTable read_table(const std::vector<std::string_view>& lines,
                        const WeatherRequest& request, Findings& findings) {
    WeatherTable table = read_header(lines, request, findings);
    read_stamps(table, lines, request.site.utc_offset, findings);
    find_step(table, findings);
    choose_clock(table, request.site);
    check_order(table, findings);
    table.begin = table.rows.front().middle;
    table.end = table.rows.back().middle + table.step;
    return table;
}

WeatherTable select_period(const WeatherTable& table,
                           const std::optional<Period>& period,
                           Findings& findings) {
    if (!period) return table;
    const auto& rows = table.rows;
    WeatherTable selected{table.columns,    table.header, table.header_line, {},
                          table.utc_offset, table.step};
    const std::string first = to_string(period->from);
    const std::string last = to_string(period->to);
    selected.begin = midnight(period->from);
    selected.end = midnight(period->to) + 24h;
    if (rows.front().middle >= selected.begin + 24h ||
        rows.back().middle < selected.end - 24h)
        findings.stop(0, 0,
                      "the file has {} to {}, but the period is {} to {}; "
                      "choose days that it has",
                      to_string(date_at(rows.front().middle)),
                      to_string(date_at(rows.back().middle)), first, last);
    const auto row_at = [&](ClockTime time) {
        return std::ranges::lower_bound(rows, time, {}, &WeatherStep::middle);
    };
    selected.rows.assign(row_at(selected.begin), row_at(selected.end));
    if (selected.rows.empty()) findings.stop(0, 0, "no row is in the period");
    return selected;
}

}  // namespace ideotype
