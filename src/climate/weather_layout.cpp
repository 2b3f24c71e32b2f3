// SPDX-License-Identifier: Apache-2.0
#include "weather_layout.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace ideotype {

namespace {

//! The lines of the head of a file.
class Head {
  public:
    Head(const std::vector<std::string_view>& lines, const std::string& file)
        : lines_(lines), file_(file) {}

    std::string_view line(std::size_t index) const {
        return index < lines_.size() ? lines_[index] : std::string_view();
    }

    std::size_t size() const { return lines_.size(); }

    [[noreturn]] void fail(std::size_t index, int column,
                           const std::string& what) const {
        throw InputError(
            {{{file_, static_cast<int>(index) + 1, column}, what}});
    }

    //! A number of a line.
    double number(std::size_t index, std::size_t entry,
                  const std::string& meaning) const {
        const std::vector<CsvField> fields = fields_of(line(index));
        const CsvField field =
            entry < fields.size() ? fields[entry] : CsvField{{}, 1};
        const std::optional<double> number = number_of(field.text);
        if (!number || !(std::abs(*number) < 1e4))
            fail(index, field.column,
                 fmt::format("the {} is not a number (\"{}\"); the head of the "
                             "file must tell it",
                             meaning, field.text));
        return *number;
    }

    //! The first line that begins so, or size().
    std::size_t find(std::string_view beginning) const {
        return static_cast<std::size_t>(
            std::find_if(lines_.begin(), lines_.end(),
                         [&](std::string_view line) {
                             return line.starts_with(beginning);
                         }) -
            lines_.begin());
    }

  private:
    const std::vector<std::string_view>& lines_;
    const std::string& file_;
};

//! Takes the names of the columns from a line; the rows follow.
void read_names(Layout& layout, const Head& head, std::size_t index) {
    layout.header = fields_of(head.line(index));
    layout.header_line = index + 1;
    layout.first_row = index + 1;
}

bool has(const Layout& layout, std::string_view name) {
    return std::any_of(layout.header.begin(), layout.header.end(),
                       [&](const CsvField& each) { return each.text == name; });
}

//! Columns that a file may have or not.
void keep_those_there(Layout& layout) {
    ColumnMap& columns = layout.columns;
    for (std::optional<Column>* column :
         {&columns.global, &columns.beam_normal, &columns.diffuse,
          &columns.temperature, &columns.humidity})
        if (*column && !has(layout, (*column)->name)) column->reset();
}

Layout energy_plus(const Head& head) {
    Layout layout;
    layout.columns.time = {"year", "month", "day", "hour", "minute"};
    layout.columns.global = {"global", "Wh/m2"};
    layout.columns.beam_normal = {"beam", "Wh/m2"};
    layout.columns.diffuse = {"diffuse", "Wh/m2"};
    layout.columns.temperature = {"temperature", "C", 99.9};
    layout.columns.humidity = {"humidity", "%", 999};
    // Names of the first fields of a row; those between are not used.
    for (const std::string_view name :
         {"year", "month", "day", "hour", "minute", "", "temperature", "",
          "humidity", "", "", "", "", "global", "beam", "diffuse"})
        layout.header.push_back({name, 0});
    layout.station = {head.number(0, 6, "latitude"),
                      head.number(0, 7, "longitude")};
    layout.columns.utc_offset = head.number(0, 8, "offset from UTC");
    const std::size_t periods = head.find("DATA PERIODS");
    if (periods == head.size())
        head.fail(0, 1,
                  "there is no line DATA PERIODS (an EPW file has 8 lines "
                  "before the data)");
    layout.hours = HourStyle::energy_plus;
    if (head.number(periods, 2, "number of records per hour") == 1)
        // Written as 0 or as 60, which is the same.
        layout.columns.time.pop_back();
    layout.first_row = periods + 1;
    layout.may_be_typical = true;
    return layout;
}

Layout tmy3(const Head& head) {
    Layout layout;
    layout.columns.time = {"Date (MM/DD/YYYY)", "Time (HH:MM)"};
    layout.columns.date_order = DateOrder::month_day_year;
    layout.columns.global = {"GHI (W/m^2)", "Wh/m2"};
    layout.columns.beam_normal = {"DNI (W/m^2)", "Wh/m2"};
    layout.columns.diffuse = {"DHI (W/m^2)", "Wh/m2"};
    layout.columns.temperature = {"Dry-bulb (C)", "C"};
    layout.columns.humidity = {"RHum (%)", "%"};
    layout.columns.utc_offset = head.number(0, 3, "offset from UTC");
    layout.station = {head.number(0, 4, "latitude"),
                      head.number(0, 5, "longitude")};
    read_names(layout, head, 1);
    layout.may_be_typical = true;
    return layout;
}

Layout nsrdb(const Head& head) {
    Layout layout;
    layout.columns.time = {"Year", "Month", "Day", "Hour", "Minute"};
    layout.columns.stamp = Stamp::middle;
    layout.columns.global = {"GHI", "W/m2"};
    layout.columns.beam_normal = {"DNI", "W/m2"};
    layout.columns.diffuse = {"DHI", "W/m2"};
    layout.columns.temperature = {"Temperature", "C"};
    layout.columns.humidity = {"Relative Humidity", "%"};
    read_names(layout, head, 0);
    const auto entry = [&](std::string_view name) {
        for (std::size_t i = 0; i < layout.header.size(); ++i)
            if (layout.header[i].text == name)
                return head.number(1, i, std::string(name));
        head.fail(0, 1, fmt::format("there is no \"{}\" in the head", name));
    };
    layout.columns.utc_offset = entry("Time Zone");
    layout.station = {entry("Latitude"), entry("Longitude")};
    read_names(layout, head, 2);
    keep_those_there(layout);
    // Hourly files of before May 2019 have minutes 0.
    const auto minute_of = [&](std::size_t line) {
        for (std::size_t i = 0; i < layout.header.size(); ++i)
            if (layout.header[i].text == "Minute")
                return head.number(line, i, "minute");
        return 0.0;
    };
    if (head.size() > 4 && minute_of(3) == 0 && minute_of(4) == 0)
        layout.columns.stamp = Stamp::beginning;
    layout.may_be_typical = true;
    return layout;
}

//! The number after a word of a line, as in "latitude  42.0".
std::optional<double> number_after(std::string_view line,
                                   std::string_view word) {
    const std::size_t at = line.find(word);
    if (at == line.npos) return std::nullopt;
    line.remove_prefix(at + word.size());
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    const auto number = number_of(line.substr(0, line.find(' ')));
    return number && std::abs(*number) <= 360 ? number : std::nullopt;
}

//! The unit in brackets of the line that explains a name.
std::string power_unit(const Head& head, const std::string& name) {
    const std::size_t index = head.find(name + " ");
    const std::string_view line = head.line(index);
    const std::size_t open = line.rfind('(');
    const std::size_t close = line.rfind(')');
    if (open == line.npos || close == line.npos || close < open) return "W/m2";
    return std::string(line.substr(open + 1, close - open - 1));
}

Layout power(const Head& head) {
    constexpr std::string_view last = "-END HEADER-";
    const std::size_t end = head.find(last);
    Layout layout;
    ColumnMap& columns = layout.columns;
    columns.time = {"YEAR", "MO", "DY", "HR"};
    columns.stamp = Stamp::beginning;
    columns.global = {"ALLSKY_SFC_SW_DWN", {}};
    columns.beam_normal = {"ALLSKY_SFC_SW_DNI", {}};
    columns.diffuse = {"ALLSKY_SFC_SW_DIFF", {}};
    columns.temperature = {"T2M", "C"};
    columns.humidity = {"RH2M", "%"};
    read_names(layout, head, end + 1);
    if (!has(layout, "HR"))
        head.fail(end + 1, 1,
                  "there is no column HR (the file is not hourly); download "
                  "the hourly data");
    for (std::optional<Column>* column :
         {&columns.global, &columns.beam_normal, &columns.diffuse})
        (*column)->unit = power_unit(head, (*column)->name);
    keep_those_there(layout);

    bool utc = false;
    for (std::size_t i = 0; i < end && i < head.size(); ++i) {
        const std::string_view line = head.line(i);
        if (line.starts_with("Dates")) utc = line.ends_with("UTC");
        const auto latitude = number_after(line, "latitude");
        const auto longitude = number_after(line, "longitude");
        if (latitude && longitude) layout.station = {*latitude, *longitude};
    }
    if (!layout.station)
        head.fail(0, 1,
                  "the head tells no latitude and longitude; download the data "
                  "of one point, with its header");
    columns.utc_offset = utc ? 0 : std::round(layout.station->longitude / 15);
    return layout;
}

Layout mapped(const Head& head, const ColumnMap& columns) {
    Layout layout;
    layout.columns = columns;
    if (columns.time.empty())
        head.fail(0, 1, "no column of the time is given; name one");
    // Some files have lines of remarks first.
    const std::string& time = columns.time.front();
    for (std::size_t i = 0; i < std::min<std::size_t>(head.size(), 100); ++i) {
        layout.header = fields_of(head.line(i));
        if (!has(layout, time)) continue;
        read_names(layout, head, i);
        return layout;
    }
    head.fail(0, 1,
              fmt::format("no line has a column \"{}\" (the header must name "
                          "the columns)",
                          time));
}

}  // namespace

Layout layout_of(const std::vector<std::string_view>& lines,
                 const WeatherRequest& request) {
    const Head head(lines, request.file);
    Layout layout = [&] {
        if (request.columns) return mapped(head, *request.columns);
        if (head.line(0).starts_with("LOCATION,")) return energy_plus(head);
        if (head.line(0).starts_with("-BEGIN HEADER-")) return power(head);
        if (head.line(0).starts_with("Source,Location ID")) return nsrdb(head);
        if (head.line(1).starts_with("Date (MM/DD/YYYY),Time (HH:MM)"))
            return tmy3(head);
        head.fail(0, 1,
                  "this is no weather file of a known format (EPW, TMY3, "
                  "NSRDB, NASA POWER); tell which columns hold what");
    }();
    if (request.stamp) layout.columns.stamp = *request.stamp;
    return layout;
}

}  // namespace ideotype
