// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ideotype/core/mapped.hpp"
#include "weather_table.hpp"

namespace ideotype {

namespace {

using namespace std::chrono;

enum class Measured {
    energy,
    photons,
    fraction,
    temperature,
    speed,
    pressure,
    depth
};

//! A spelling of a unit, reduced to lower-case letters, digits and %, with the
//! spelling used in campaigns.
struct Spelling {
    Measured kind;
    std::string_view text, unit;
};

constexpr std::array spellings{
    Spelling{Measured::energy, "wm2", "W/m2"},
    Spelling{Measured::energy, "w", "W/m2"},
    Spelling{Measured::energy, "kwm2", "kW/m2"},
    Spelling{Measured::energy, "whm2", "Wh/m2"},
    Spelling{Measured::energy, "wh", "Wh/m2"},
    Spelling{Measured::energy, "kwhm2", "kWh/m2"},
    Spelling{Measured::energy, "kjm2", "kJ/m2"},
    Spelling{Measured::energy, "kj", "kJ/m2"},
    Spelling{Measured::energy, "mjm2", "MJ/m2"},
    Spelling{Measured::energy, "mj", "MJ/m2"},
    Spelling{Measured::energy, "mjm2h", "MJ/m2"},
    Spelling{Measured::energy, "mjm2h1", "MJ/m2"},
    Spelling{Measured::photons, "umolm2s", "umol/m2/s"},
    Spelling{Measured::photons, "umolm2s1", "umol/m2/s"},
    Spelling{Measured::photons, "umol", "umol/m2/s"},
    Spelling{Measured::fraction, "%", "%"},
    Spelling{Measured::fraction, "percent", "%"},
    Spelling{Measured::fraction, "pct", "%"},
    Spelling{Measured::fraction, "1", "1"},
    Spelling{Measured::fraction, "fraction", "1"},
    Spelling{Measured::temperature, "c", "C"},
    Spelling{Measured::temperature, "degc", "C"},
    Spelling{Measured::temperature, "k", "K"},
    Spelling{Measured::temperature, "f", "F"},
    Spelling{Measured::temperature, "degf", "F"},
    Spelling{Measured::speed, "ms", "m/s"},
    Spelling{Measured::speed, "ms1", "m/s"},
    Spelling{Measured::speed, "kmh", "km/h"},
    Spelling{Measured::speed, "mph", "mph"},
    Spelling{Measured::speed, "kn", "kn"},
    Spelling{Measured::pressure, "kpa", "kPa"},
    Spelling{Measured::pressure, "hpa", "hPa"},
    Spelling{Measured::pressure, "mbar", "mbar"},
    Spelling{Measured::pressure, "pa", "Pa"},
    Spelling{Measured::depth, "mm", "mm"},
    Spelling{Measured::depth, "in", "in"},
    Spelling{Measured::depth, "inch", "in"},
    Spelling{Measured::depth, "mmh", "mm/h"},
    Spelling{Measured::depth, "mmh1", "mm/h"},
    Spelling{Measured::depth, "mmhour", "mm/h"},
};

//! A quantity, and the beginnings of column names that denote it, as simplify()
//! returns them.
struct Meaning {
    std::optional<Column> ColumnMap::*column;
    Measured kind;
    std::vector<std::string_view> names;
};

//! The first match applies. Diffuse light precedes global light, since both may
//! be called radiation.
const std::vector<Meaning> meanings{
    {&ColumnMap::diffuse_fraction, Measured::fraction, {"diffusefraction"}},
    {&ColumnMap::diffuse, Measured::energy, {"diffuse", "dhi"}},
    {&ColumnMap::beam_normal,
     Measured::energy,
     {"dni", "beamnormal", "directnormal"}},
    {&ColumnMap::longwave, Measured::energy, {"longwave", "lwdown"}},
    {&ColumnMap::global,
     Measured::energy,
     {"global", "ghi", "glob", "srad", "solar", "shortwave", "swdown",
      "radiation"}},
    {&ColumnMap::ppfd, Measured::photons, {"ppfd", "par", "photons"}},
    {&ColumnMap::temperature,
     Measured::temperature,
     {"temp", "airtemp", "tair", "t2m"}},
    {&ColumnMap::humidity,
     Measured::fraction,
     {"rh", "humidity", "relhum", "relativehumidity"}},
    {&ColumnMap::wind, Measured::speed, {"wind", "ws"}},
    {&ColumnMap::pressure, Measured::pressure, {"pressure", "press"}},
    {&ColumnMap::rain, Measured::depth, {"rain", "precip", "prectot"}},
};

//! Reduces a text to lower-case letters, digits and percent signs; the micro
//! sign becomes u.
std::string simplify(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        if (text.substr(i).starts_with("\xC2\xB5") ||
            text.substr(i).starts_with("\xCE\xBC"))
            result += 'u', ++i;
        else if (text.substr(i).starts_with("\xC2\xB2"))
            result += '2', ++i;
        else if (c < 0x80 && (std::isalnum(c) != 0 || c == '%'))
            result += static_cast<char>(std::tolower(c));
    }
    return result;
}

//! Finds the unit of a quantity at the end of a column name, in brackets or
//! after a separator; returns "" if there is none.
std::string_view find_unit(std::string_view column, Measured kind) {
    for (std::size_t end = column.find_first_of("([_ "); end != column.npos;
         end = column.find_first_of("([_ ", end + 1)) {
        const std::string rest = simplify(column.substr(end));
        for (const Spelling& spelling : spellings)
            if (spelling.kind == kind && spelling.text == rest)
                return spelling.unit;
    }
    return "";
}

//! Returns the columns of a header that contain the time; empty if none do.
std::vector<std::string> find_time_columns(
    const std::vector<CsvField>& header) {
    const auto find =
        [&](std::initializer_list<const char*> names) -> std::string {
        for (const char* const name : names)
            for (const CsvField& field : header)
                if (simplify(field.text) == name)
                    return std::string(field.text);
        return "";
    };
    std::vector<std::string> parts{find({"year", "yr"}), find({"month", "mo"}),
                                   find({"day"}), find({"hour", "hr"})};
    if (std::ranges::count(parts, "") == 0) {
        if (const std::string minute = find({"minute"}); !minute.empty())
            parts.push_back(minute);
        return parts;
    }
    const std::string date = find({"date"}), time = find({"time", "clock"});
    if (!date.empty() && !time.empty()) return {date, time};
    const std::string both = find(
        {"time", "datetime", "timestamp", "dateandtime", "localtime", "date"});
    return both.empty() ? std::vector<std::string>{} : std::vector{both};
}

//! Recognises the columns of light and weather in a header.
ColumnMap find_value_columns(const std::vector<CsvField>& header) {
    ColumnMap columns;
    for (const CsvField& field : header) {
        const std::string name = simplify(field.text);
        for (const Meaning& meaning : meanings) {
            std::optional<Column>& column = columns.*meaning.column;
            const std::string_view unit = find_unit(field.text, meaning.kind);
            const bool is_called = std::ranges::any_of(
                meaning.names,
                [&](auto part) { return name.starts_with(part); });
            if (column || unit.empty() || !is_called) continue;
            column = Column{std::string(field.text), std::string(unit)};
            break;
        }
    }
    // Use photons only if no other column gives the light.
    if (!columns.global && !columns.beam_normal)
        std::swap(columns.global, columns.ppfd);
    return columns;
}

//! Finds the first and the last day with a row for every step.
Period find_whole_days(const WeatherTable& table, const Findings& findings) {
    const ClockTime first = table.rows.front().middle,
                    last = table.rows.back().middle;
    sys_days first_day{floor<days>(first).time_since_epoch()};
    sys_days last_day{floor<days>(last).time_since_epoch()};
    if (first - floor<days>(first) >= table.step) first_day += days{1};
    if (floor<days>(last) + 24h - last > table.step) last_day -= days{1};
    if (last_day < first_day)
        findings.stop(0, 0, "the file has no whole day; give a longer one");
    return {date_at(ClockTime{first_day.time_since_epoch()}),
            date_at(ClockTime{last_day.time_since_epoch()})};
}

}  // namespace

WeatherDescription describe_weather(const std::string& text,
                                    const std::string& file, const Site& site) {
    const std::vector<std::string_view> lines = split_lines(text);
    Findings findings(file);
    ColumnMap columns;
    std::vector<CsvField> header;
    // Look for a header in the first lines, and infer the order of day, month
    // and year from all rows.
    for (std::size_t i = 0; i < std::min<std::size_t>(lines.size(), 100); ++i) {
        header = split_fields(lines[i]);
        if (header.size() < 2 || find_time_columns(header).empty()) continue;
        columns = find_value_columns(header);
        columns.time = find_time_columns(header);
        std::vector<std::vector<CsvField>> stamps;
        for (std::size_t row = i + 1; row < lines.size(); ++row) {
            const std::vector<CsvField> fields = split_fields(lines[row]);
            if (fields.size() < 2) continue;
            std::vector<CsvField>& stamp = stamps.emplace_back();
            for (const std::string& name : columns.time)
                stamp.push_back(
                    entry(fields,
                          static_cast<std::size_t>(
                              std::ranges::find(header, name, &CsvField::text) -
                              header.begin())));
        }
        columns.date_order =
            find_date_order(stamps).value_or(DateOrder::year_month_day);
        break;
    }
    WeatherRequest request{file, site};
    // Files written by `ideotype weather` have no units in their header.
    if (columns.global || (columns.beam_normal && columns.diffuse))
        request.columns = columns;
    else if (std::ranges::count(header, "global", &CsvField::text) == 0 &&
             std::ranges::count(header, "beam_normal", &CsvField::text) == 0)
        findings.stop(
            1, 1,
            "no columns of time and light are recognised{}; name the light "
            "with its unit, such as \"global (W/m2)\", convert the file by "
            "ideotype weather, or write [[climate]] by hand: docs/site.md",
            columns.time.empty()
                ? ""
                : fmt::format(
                      " (the file has {})",
                      fmt::join(mapped(header, &CsvField::text), ", ")));
    return {request.columns,
            find_whole_days(read_table(lines, request, findings), findings)};
}

}  // namespace ideotype
