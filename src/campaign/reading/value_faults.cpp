// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "nodes.hpp"
#include "spelling.hpp"
#include "values.hpp"

namespace ideotype {

namespace {

bool has_dates(const Key& key) {
    return std::holds_alternative<Date*>(key.value) ||
           std::holds_alternative<std::vector<Date>*>(key.value);
}

//! Returns a text without its quotes as TOML, if it then has the right type.
std::optional<std::string> without_quotes(const toml::node& found,
                                          const Key& key) {
    const auto text = found.value<std::string>();
    if (!text) return std::nullopt;
    if (has_dates(key)) return meant_date(*text);
    if (!std::holds_alternative<double*>(key.value)) return std::nullopt;
    return key.is_clock() ? meant_time(*text) : meant_number(*text);
}

}  // namespace

std::string ValueFaults::name() const {
    return section == "top" ? key.name : section + '.' + key.name;
}

void ValueFaults::fail_type(const toml::node& found) const {
    if (const auto meant = without_quotes(found, key))
        return fail("is a text (expected: {}); write {} = {} without quotes",
                    key.type, key.name, *meant);
    if (const auto text = found.value<std::string>(); text && has_dates(key))
        if (text->size() == 10 && text->at(4) == '-' && text->at(7) == '-')
            return fail("is {} (the calendar has no such day); use another day",
                        *text);
    const std::string example =
        key.example.empty() ? toml_text(key) : key.example;
    if (const auto number = found.value<double>();
        number && !std::isfinite(*number))
        return fail(
            "is {} (not a finite number; expected: {}); write for "
            "example {} = {}",
            *number, key.type, key.name, example);
    fail("is {} (expected: {}); write for example {} = {}", kind(found),
         key.type, key.name, example);
}

//! Returns the fault of a number, or "" if it has none.
std::string ValueFaults::fault(double value) const {
    const std::string unit = key.unit.empty() ? "" : ' ' + key.unit;
    if (!std::isfinite(value))
        return fmt::format(
            "is {} (not a finite number); give a number{}", value,
            key.lower == key.upper ? std::string() : " in " + range_text(key));
    if (key.lower == key.upper) return "";
    if (value < key.lower)
        return fmt::format("is {}{} (below the range {}); use {}{} or more",
                           value, unit, range_text(key), key.lower, unit);
    if (value > key.upper)
        return fmt::format("is {}{} (above the range {}); use {}{} or less",
                           value, unit, range_text(key), key.upper, unit);
    return "";
}

//! Reports a number that is in the range if it is in another unit; other
//! entries of a file most likely give this key in the same unit.
bool ValueFaults::is_mistaken(double value) const {
    if (!(value > key.upper)) return false;
    std::vector<std::string> units, values;
    for (const auto& [unit, in_ours] : key.mistaken) {
        const double meant = value * in_ours;
        if (meant < key.lower || meant > key.upper) continue;
        units.push_back(unit);
        values.push_back(fmt::format("{:.6g}", meant));
    }
    if (units.empty()) return false;
    const bool is_length = key.unit == "m";
    problems.add_once(
        key.name, name(),
        fmt::format("{} is {}{}{} (above the range {}, it looks like {}); "
                    "give {}: {}{}",
                    name(), value, key.unit.empty() ? "" : " ", key.unit,
                    range_text(key), fmt::join(units, " or "),
                    is_length ? "metres" : "a fraction",
                    fmt::join(values, " or "),
                    is_length ? ", and check all lengths of this file" : ""));
    return true;
}

bool ValueFaults::accepts(double value) const {
    if (is_mistaken(value)) return false;
    const std::string why = fault(value);
    if (!why.empty()) fail("{}", why);
    return why.empty();
}

}  // namespace ideotype
