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

enum class Measured { energy, photons, fraction, temperature, speed, pressure };

//! A spelling of a unit, in lower case without other characters than letters,
//! digits and %, and the unit in the spelling of campaigns.
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
};

//! A quantity, and the names of its columns: the beginnings of bare() texts.
struct Meaning {
    std::optional<Column> ColumnMap::*column;
    Measured kind;
    std::vector<std::string_view> names;
};

//! The first that fits counts: diffuse light comes before global light, since
//! either may be called radiation.
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
};

//! Returns the letters, digits and percent signs of a text in lower case, with
//! u for the micro sign.
std::string bare(std::string_view text) {
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

//! Returns the unit at the end of a column's name, in brackets or after a
//! separator, of a kind; "" if there is none.
std::string_view unit_of(std::string_view column, Measured kind) {
    for (std::size_t end = column.find_first_of("([_ "); end != column.npos;
         end = column.find_first_of("([_ ", end + 1)) {
        const std::string rest = bare(column.substr(end));
        for (const Spelling& each : spellings)
            if (each.kind == kind && each.text == rest) return each.unit;
    }
    return "";
}

//! Returns the columns of the time of a header; none if there are none.
std::vector<std::string> time_columns(const std::vector<CsvField>& header) {
    const auto called =
        [&](std::initializer_list<const char*> names) -> std::string {
        for (const char* const name : names)
            for (const CsvField& each : header)
                if (bare(each.text) == name) return std::string(each.text);
        return "";
    };
    std::vector<std::string> parts{called({"year", "yr"}),
                                   called({"month", "mo"}), called({"day"}),
                                   called({"hour", "hr"})};
    if (std::ranges::count(parts, "") == 0) {
        if (const std::string minute = called({"minute"}); !minute.empty())
            parts.push_back(minute);
        return parts;
    }
    const std::string date = called({"date"}), time = called({"time", "clock"});
    if (!date.empty() && !time.empty()) return {date, time};
    const std::string both = called(
        {"time", "datetime", "timestamp", "dateandtime", "localtime", "date"});
    return both.empty() ? std::vector<std::string>{} : std::vector{both};
}

//! Returns the columns of the light and the weather of a header.
ColumnMap value_columns(const std::vector<CsvField>& header) {
    ColumnMap columns;
    for (const CsvField& field : header) {
        const std::string name = bare(field.text);
        for (const Meaning& each : meanings) {
            std::optional<Column>& column = columns.*each.column;
            const std::string_view unit = unit_of(field.text, each.kind);
            const bool is_called = std::ranges::any_of(
                each.names, [&](auto part) { return name.starts_with(part); });
            if (column || unit.empty() || !is_called) continue;
            column = Column{std::string(field.text), std::string(unit)};
            break;
        }
    }
    // Photons alone are the light.
    if (!columns.global && !columns.beam_normal)
        std::swap(columns.global, columns.ppfd);
    return columns;
}

//! Returns the first and the last day of which all steps have rows.
Period whole_days(const WeatherTable& table, const Findings& findings) {
    const ClockTime first = table.rows.front().middle,
                    last = table.rows.back().middle;
    sys_days from{floor<days>(first).time_since_epoch()};
    sys_days to{floor<days>(last).time_since_epoch()};
    if (first - floor<days>(first) >= table.step) from += days{1};
    if (floor<days>(last) + 24h - last > table.step) to -= days{1};
    if (to < from)
        findings.stop(0, 0, "the file has no whole day; give a longer one");
    return {date_at(ClockTime{from.time_since_epoch()}),
            date_at(ClockTime{to.time_since_epoch()})};
}

}  // namespace

WeatherDescription describe_weather(const std::string& text,
                                    const std::string& file, const Site& site) {
    const std::vector<std::string_view> lines = lines_of(text);
    Findings findings(file);
    ColumnMap columns;
    std::vector<CsvField> header;
    for (std::size_t i = 0; i < std::min<std::size_t>(lines.size(), 100); ++i) {
        header = fields_of(lines[i]);
        if (header.size() < 2 || time_columns(header).empty()) continue;
        columns = value_columns(header);
        columns.time = time_columns(header);
        std::vector<std::vector<CsvField>> stamps;
        for (std::size_t row = i + 1; row < lines.size(); ++row) {
            const std::vector<CsvField> fields = fields_of(lines[row]);
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
            order_of_dates(stamps).value_or(DateOrder::year_month_day);
        break;
    }
    WeatherRequest request{file, site};
    // The columns that `ideotype weather` writes have no units in their names.
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
            whole_days(read_table(lines, request, findings), findings)};
}

}  // namespace ideotype
