// SPDX-License-Identifier: Apache-2.0
#include "json.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "ideotype/core/text.hpp"
#include "run/progress.hpp"

namespace ideotype {

namespace {

bool is_estimate(const Json& json) {
    return json.is_object() && json.contains("mean");
}

bool is_value(const Json& json) {
    return json.is_primitive() || is_estimate(json);
}

}  // namespace

std::string text_of(const Json& value) {
    if (is_estimate(value)) {
        if (value.contains("name")) return value["name"].get<std::string>();
        const Json& error = value["standard_error"];
        const double unknown = std::numeric_limits<double>::quiet_NaN();
        return with_unit(
            format({value["mean"].get<double>(),
                    error.is_number() ? error.get<double>() : unknown}),
            value.value("unit", "1"));
    }
    if (value.is_number_float())
        return fmt::format("{:.6g}", value.get<double>());
    if (value.is_string()) return value.get<std::string>();
    return value.is_null() ? "-" : to_line(value);
}

void print_table(const Json& rows, std::size_t indent) {
    std::vector<std::string> names;
    for (const Json& row : rows)
        for (const auto& [name, value] : row.items())
            if (is_value(value) && !name.ends_with("unit") &&
                std::ranges::count(names, name) == 0)
                names.push_back(name);
    std::vector<std::string> lines(rows.size() + 1);
    for (const std::string& name : names) {
        std::vector<std::string> cells{name};
        for (const Json& row : rows)
            cells.push_back(text_of(row.value(name, Json())));
        std::size_t width = 0;
        for (const std::string& cell : cells)
            width = std::max(width, count_columns(cell) + 2);
        for (std::size_t i = 0; i < lines.size(); ++i)
            lines[i] += fmt::format("{:>{}}", cells[i], width);
    }
    for (const std::string& line : lines)
        fmt::print("{:{}}{}\n", "", indent, line);
}

void print_outline(const Json& json, std::size_t indent) {
    constexpr std::size_t width = 36;
    for (const auto& [name, value] : json.items()) {
        const bool is_unit = name.ends_with("_unit") &&
                             json.contains(name.substr(0, name.rfind("_unit")));
        if (is_unit || value.empty()) continue;
        if (is_value(value)) {
            fmt::print(
                "{:{}}{:<{}} {}\n", "", indent, name, width - indent,
                with_unit(text_of(value), json.value(name + "_unit", "1")));
            continue;
        }
        fmt::print("{}{:{}}{}\n", indent == 0 ? "\n" : "", "", indent, name);
        if (value.is_object())
            print_outline(value, indent + 2);
        else if (value.front().is_object())
            print_table(value, indent + 2);
        else
            for (const Json& each : value)
                fmt::print("{:{}}{}\n", "", indent + 2, text_of(each));
    }
}

}  // namespace ideotype
