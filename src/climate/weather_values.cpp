// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "ideotype/core/units.hpp"
#include "weather_table.hpp"

namespace ideotype {

namespace {

enum class Kind { light, fraction, temperature, speed, pressure, depth };

//! Whether a value is given as such or per hour, and whether light is given as
//! power, as energy per time step, or as photons.
enum class Per { itself, second, photon, hour };

//! The linear conversion of a number in a file to the program's unit: number
//! times factor plus offset.
struct Scale {
    double factor = 1;
    double offset = 0;
};

struct Unit {
    Kind kind;
    std::string_view name;
    Scale scale;
    Per per = Per::itself;
};

constexpr std::array units{
    Unit{Kind::light, "W/m2", {}},
    Unit{Kind::light, "kW/m2", {1e3}},
    Unit{Kind::light, "Wh/m2", {3600}, Per::second},
    Unit{Kind::light, "kWh/m2", {3.6e6}, Per::second},
    Unit{Kind::light, "kJ/m2", {1e3}, Per::second},
    Unit{Kind::light, "MJ/m2", {1e6}, Per::second},
    Unit{Kind::light, "umol/m2/s", {1}, Per::photon},
    Unit{Kind::fraction, "1", {}},
    Unit{Kind::fraction, "%", {0.01}},
    Unit{Kind::temperature, "C", {}},
    Unit{Kind::temperature, "K", {1, -273.15}},
    Unit{Kind::temperature, "F", {5 / 9.0, -160 / 9.0}},
    Unit{Kind::speed, "m/s", {}},
    Unit{Kind::speed, "km/h", {1 / 3.6}},
    Unit{Kind::speed, "mph", {0.44704}},
    Unit{Kind::speed, "kn", {1.852 / 3.6}},
    Unit{Kind::pressure, "kPa", {}},
    Unit{Kind::pressure, "hPa", {0.1}},
    Unit{Kind::pressure, "mbar", {0.1}},
    Unit{Kind::pressure, "Pa", {1e-3}},
    Unit{Kind::depth, "mm", {}},
    Unit{Kind::depth, "in", {25.4}},
    Unit{Kind::depth, "mm/h", {1. / 3600}, Per::hour},
};

//! Normalises the spelling of a unit.
std::string normalize(std::string_view unit) {
    std::string text(unit);
    constexpr std::array<std::pair<std::string_view, std::string_view>, 10>
        replacements{
            {{"\xC2\xB5", "u"},  // micro sign
             {"\xCE\xBC", "u"},  // Greek mu
             {"\xC2\xB2", "2"},  // superscript two
             {"\xC2\xB0", ""},   // degree sign
             {"^", ""},
             {" m-2 s-1", "/m2/s"},
             {" m-2", "/m2"},
             {" ", ""},
             {"W-hr", "Wh"},
             {"MJ/hr",
              "MJ/m2"}}};  // unit of NASA POWER for agriculture, per m2
    for (const auto& [pattern, replacement] : replacements)
        for (std::size_t at; (at = text.find(pattern)) != text.npos;)
            text.replace(at, pattern.size(), replacement);
    return text;
}

//! A column, with the conversion and the plausible range of its values.
struct Source {
    std::size_t index = 0;
    Scale scale;
    std::optional<double> WeatherValues::*target = nullptr;
    double lowest = 0, highest = 0;
    std::string_view unit;
};

//! Finds the columns with values and the conversions of their units. Also sets
//! whether light is given in photons.
std::vector<Source> find_sources(WeatherTable& table, double par_fraction,
                                 Findings& findings) {
    using Values = WeatherValues;
    const ColumnMap& columns = table.columns;
    const auto decisive =
        columns.global ? &Values::global : &Values::beam_normal;
    std::vector<Source> sources;
    const auto add = [&](const std::optional<Column>& column, Kind kind,
                         Source source) {
        if (!column) return;
        source.index = table.find_column(column->name, findings).value_or(0);
        const std::string name = normalize(column->unit);
        // Find the unit among those of the quantity.
        std::string names;
        for (const Unit& unit : units) {
            if (unit.kind != kind) continue;
            if (unit.per == Per::photon && source.target == &Values::longwave)
                continue;
            names += fmt::format("{}{}", names.empty() ? "" : ", ", unit.name);
            if (unit.name != name) continue;
            source.scale = unit.scale;
            if (unit.per == Per::second)
                source.scale.factor /= static_cast<double>(table.step.count());
            if (unit.per == Per::hour)
                source.scale.factor *= static_cast<double>(table.step.count());
            if (unit.per == Per::photon) {
                source.scale.factor /= mol_per_mj_par * par_fraction;
                if (source.target == decisive) table.counts_photons = true;
            }
            return sources.push_back(source);
        }
        findings.add(
            static_cast<int>(table.header_line), 1,
            "\"{}\" is not a unit for the column \"{}\"; use one of {}",
            column->unit, column->name, names);
    };
    Source light{0, {}, &Values::global, -20, 2000, "W m-2"};
    add(columns.global, Kind::light, light);
    light.target = &Values::beam_normal;
    add(columns.beam_normal, Kind::light, light);
    light.target = &Values::diffuse;
    add(columns.diffuse, Kind::light, light);
    light.target = &Values::ppfd;
    add(columns.ppfd, Kind::light, light);
    add(columns.diffuse_fraction, Kind::fraction,
        {0, {}, &Values::diffuse_fraction, 0, 1.01, "of the global light"});
    add(columns.temperature, Kind::temperature,
        {0, {}, &Values::temperature, -90, 60, "deg C"});
    add(columns.humidity, Kind::fraction,
        {0, {}, &Values::humidity, 0, 1.1, "of saturation"});
    add(columns.wind, Kind::speed, {0, {}, &Values::wind, 0, 75, "m s-1"});
    add(columns.pressure, Kind::pressure,
        {0, {}, &Values::pressure, 40, 110, "kPa"});
    add(columns.longwave, Kind::light,
        {0, {}, &Values::longwave, 50, 700, "W m-2"});
    add(columns.rain, Kind::depth, {0, {}, &Values::rain, 0, 2000, "mm"});
    if (!columns.global && !(columns.beam_normal && columns.diffuse))
        findings.add(static_cast<int>(table.header_line), 1,
                     "no column contains the light; name the column of global "
                     "light, or those of beam and diffuse light");
    findings.stop_if_any();
    return sources;
}

//! Reads a value in the program's unit; returns nothing if it is missing.
std::optional<double> read_value(const CsvField& field, const Source& source,
                                 std::optional<double> missing, int line,
                                 Findings& findings) {
    constexpr std::array words{"", "NA", "NaN", "nan", "null", "-"};
    constexpr std::array codes{-99.0,   -999.0, -9900.0,
                               -9999.0, 9999.0, 99999.0};
    if (std::find(words.begin(), words.end(), field.text) != words.end())
        return std::nullopt;
    const std::optional<double> number = parse_number(field.text);
    if (!number || std::isinf(*number)) {
        findings.add_row(
            source.index, line, field.column,
            "\"{}\" is not a number; correct it, or leave the entry empty",
            field.text);
        return std::nullopt;
    }
    if (std::isnan(*number) || number == missing ||
        std::find(codes.begin(), codes.end(), *number) != codes.end())
        return std::nullopt;
    const double value = source.scale.factor * *number + source.scale.offset;
    // Impossible values usually mean a wrong unit.
    if (value < source.lowest || value > source.highest)
        findings.add_row(source.index, line, field.column,
                         "{} means {:.4g} {} (outside {:g} to {:g}); check the "
                         "unit, or the code of missing values",
                         field.text, value, source.unit, source.lowest,
                         source.highest);
    return value;
}

}  // namespace

void read_values(WeatherTable& table,
                 const std::vector<std::string_view>& lines,
                 double par_fraction, Findings& findings) {
    const auto sources = find_sources(table, par_fraction, findings);
    for (WeatherStep& row : table.rows) {
        const std::vector<CsvField> fields =
            split_fields(lines[static_cast<std::size_t>(row.line) - 1]);
        for (const Source& source : sources)
            row.values.*source.target =
                read_value(entry(fields, source.index), source,
                           table.columns.missing, row.line, findings);
    }
    findings.stop_if_any();
}

}  // namespace ideotype
