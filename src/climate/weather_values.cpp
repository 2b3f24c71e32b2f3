// SPDX-License-Identifier: Apache-2.0
#include "weather_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "weather_problems.hpp"
#include "weather_units.hpp"

namespace ideotype {

namespace {

//! The index of a column, and how its numbers become ours.
struct Source {
    std::size_t index = 0;
    Scale scale;
    std::optional<double> missing;
    std::optional<double> WeatherValues::*target = nullptr;
};

class ValuesReader {
  public:
    ValuesReader(const std::vector<std::string_view>& lines,
                 const Layout& layout, const RowTimes& times,
                 const WeatherRequest& request)
        : lines_(lines),
          layout_(layout),
          times_(times),
          request_(request),
          problems_(request.file) {}

    std::vector<WeatherValues> read() {
        const std::vector<Source> sources = find_sources();
        problems_.stop_if_any();
        std::vector<WeatherValues> all;
        for (const RowTime& row : times_.rows) {
            const std::vector<CsvField> fields =
                fields_of(lines_[static_cast<std::size_t>(row.line) - 1]);
            WeatherValues& values = all.emplace_back();
            for (const Source& source : sources)
                values.*source.target =
                    value_of(entry(fields, source.index), source, row.line);
        }
        problems_.stop_if_any();
        return all;
    }

  private:
    std::vector<Source> find_sources() {
        std::vector<Source> sources;
        const auto add = [&](const std::optional<Column>& column, Kind kind,
                             std::optional<double> WeatherValues::*target) {
            if (!column) return;
            const auto index = column_index(layout_, column->name, problems_);
            const auto scale = scale_of(
                kind, column->unit, static_cast<double>(times_.step.count()),
                request_.par_fraction);
            if (!scale)
                problems_.add(
                    static_cast<int>(layout_.header_line), 1,
                    fmt::format("\"{}\" is no unit of the column \"{}\"; there "
                                "are {}",
                                column->unit, column->name, units_of(kind)));
            if (index && scale)
                sources.push_back({*index, *scale, column->missing, target});
        };
        const ColumnMap& columns = layout_.columns;
        add(columns.global, Kind::light, &WeatherValues::global);
        add(columns.beam_normal, Kind::light, &WeatherValues::beam_normal);
        add(columns.diffuse, Kind::light, &WeatherValues::diffuse);
        add(columns.diffuse_fraction, Kind::fraction,
            &WeatherValues::diffuse_fraction);
        add(columns.temperature, Kind::temperature,
            &WeatherValues::temperature);
        add(columns.humidity, Kind::fraction, &WeatherValues::humidity);
        if (!columns.global && !(columns.beam_normal && columns.diffuse))
            problems_.add(
                static_cast<int>(layout_.header_line), 1,
                "no column tells the light; there must be the global light, or "
                "the beam and the diffuse");
        return sources;
    }

    std::optional<double> value_of(const CsvField& field, const Source& source,
                                   int line) {
        constexpr std::array words{"", "NA", "NaN", "nan", "null", "-"};
        constexpr std::array codes{-99.0,   -999.0, -9900.0,
                                   -9999.0, 9999.0, 99999.0};
        if (std::find(words.begin(), words.end(), field.text) != words.end())
            return std::nullopt;
        const std::optional<double> number = number_of(field.text);
        if (!number || std::isinf(*number)) {
            problems_.add(line, field.column,
                          fmt::format("\"{}\" is not a number", field.text));
            return std::nullopt;
        }
        if (std::isnan(*number) || number == source.missing ||
            std::find(codes.begin(), codes.end(), *number) != codes.end())
            return std::nullopt;
        const double value =
            source.scale.factor * *number + source.scale.offset;
        check_range(value, field, source, line);
        return value;
    }

    //! What no weather is: most often another unit.
    void check_range(double value, const CsvField& field, const Source& source,
                     int line) {
        struct Limits {
            double lowest, highest;
            std::string_view what;
        };
        const Limits limits =
            source.target == &WeatherValues::temperature
                ? Limits{-90, 60, "deg C"}
            : source.target == &WeatherValues::humidity
                ? Limits{0, 1.1, "of saturation"}
            : source.target == &WeatherValues::diffuse_fraction
                ? Limits{0, 1.01, "of the global light"}
                : Limits{-20, 2000, "W m-2"};
        if (value < limits.lowest || value > limits.highest)
            problems_.add(
                line, field.column,
                fmt::format("{} means {:.4g} {} (outside {:g} to {:g}); check "
                            "the unit, or what stands for missing values",
                            field.text, value, limits.what, limits.lowest,
                            limits.highest));
    }

    const std::vector<std::string_view>& lines_;
    const Layout& layout_;
    const RowTimes& times_;
    const WeatherRequest& request_;
    Problems problems_;
};

}  // namespace

std::vector<WeatherValues> read_values(
    const std::vector<std::string_view>& lines, const Layout& layout,
    const RowTimes& times, const WeatherRequest& request) {
    return ValuesReader(lines, layout, times, request).read();
}

}  // namespace ideotype
