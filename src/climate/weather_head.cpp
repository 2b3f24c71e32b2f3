// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "weather_table.hpp"

namespace ideotype {

namespace {

bool has(const std::vector<CsvField>& header, std::string_view name) {
    return std::any_of(header.begin(), header.end(),
                       [&](const CsvField& each) { return each.text == name; });
}

//! Returns the columns that `ideotype weather` writes, of those that are there.
ColumnMap native_columns(ColumnMap columns,
                         const std::vector<CsvField>& header) {
    columns.time = {"time"};
    columns.stamp = columns.stamp.value_or(Stamp::middle);
    const auto find = [&](std::optional<Column>& column, const char* name,
                          const char* unit) {
        if (has(header, name)) column = Column{name, unit};
    };
    find(columns.global, "global", "W/m2");
    find(columns.beam_normal, "beam_normal", "W/m2");
    find(columns.diffuse, "diffuse", "W/m2");
    find(columns.temperature, "temperature", "C");
    find(columns.humidity, "humidity", "%");
    return columns;
}

//! Says how a file of another format becomes one that can be read.
std::string way_to_convert(const WeatherRequest& request) {
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
    return "this is no table with columns time and global; say which columns "
           "hold what, or convert it and name what this writes: " +
           command;
}

}  // namespace

WeatherTable read_head(const std::vector<std::string_view>& lines,
                       const WeatherRequest& request, Findings& findings) {
    WeatherTable table{request.columns, {}};
    const bool is_native = request.columns.time.empty();
    const std::string time = is_native ? "time" : request.columns.time.front();
    for (std::size_t i = 0; i < std::min<std::size_t>(lines.size(), 100); ++i) {
        table.header = fields_of(lines[i]);
        table.header_line = i + 1;
        if (!has(table.header, time)) continue;
        if (!is_native) return table;
        table.columns = native_columns(request.columns, table.header);
        if (!table.columns.global && !table.columns.beam_normal) break;
        return table;
    }
    if (is_native) findings.stop(1, 1, "{}", way_to_convert(request));
    findings.stop(
        1, 1, "no line has a column \"{}\" (the header must name the columns)",
        time);
}

std::optional<std::size_t> WeatherTable::index_of(const std::string& name,
                                                  Findings& findings) const {
    const auto is_it = [&](const CsvField& each) { return each.text == name; };
    const auto found = std::find_if(header.begin(), header.end(), is_it);
    const int line = static_cast<int>(header_line);
    if (found == header.end()) {
        std::vector<std::string> names;
        for (const CsvField& each : header) names.emplace_back(each.text);
        const std::string near = nearest_name(name, names);
        findings.add(line, 1, "there is no column \"{}\"{}", name,
                     near.empty() ? "" : "; is it \"" + near + "\"?");
        return std::nullopt;
    }
    if (std::find_if(found + 1, header.end(), is_it) != header.end())
        findings.add(line, found->column,
                     "two columns have the name \"{}\"; rename one of them",
                     name);
    return static_cast<std::size_t>(found - header.begin());
}

}  // namespace ideotype
