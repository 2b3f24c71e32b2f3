// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "nodes.hpp"
#include "spelling.hpp"
#include "values.hpp"
#include "writer.hpp"

namespace ideotype {

namespace {

bool has_dates(const Target& value) {
    return std::holds_alternative<Date*>(value) ||
           std::holds_alternative<std::vector<Date>*>(value);
}

//! Returns a space and the unit of a key, or "" if the key has no unit.
std::string with_unit(const Key& key) {
    return *key.values.unit ? fmt::format(" {}", key.values.unit) : "";
}

//! Returns an example of a key's value for messages. It is the declared
//! example, the current value, or the number or text with which the default in
//! words begins.
std::string example_of(const BoundKey& key) {
    const auto& [words, example, is_required] = key.key.initial;
    const std::string text = *example ? example : toml_text(key);
    if (!text.empty() || !words) return text;
    const std::string_view phrase = words;
    const bool is_value =
        phrase[0] == '"' || (phrase[0] >= '0' && phrase[0] <= '9');
    return std::string(is_value ? phrase.substr(0, phrase.find_first_of(",; "))
                                : "");
}

//! Returns a quoted text without its quotes as TOML, if it then has the right
//! type.
std::optional<std::string> without_quotes(const toml::node& node,
                                          const BoundKey& key) {
    const auto text = node.value<std::string>();
    if (!text) return std::nullopt;
    if (has_dates(key.value)) return meant_date(*text);
    if (!std::holds_alternative<double*>(key.value) &&
        !std::holds_alternative<std::optional<double>*>(key.value))
        return std::nullopt;
    return key.key.values.form == Form::clock ? meant_time(*text)
                                              : meant_number(*text);
}

}  // namespace

std::string ValueFaults::name() const {
    if (const auto name = problems.name_of(key.name)) return *name;
    return section == "top" ? std::string(key.name) : section + '.' + key.name;
}

void ValueFaults::fail_type(const toml::node& node) const {
    if (const auto meant = without_quotes(node, bound))
        return fail(wrong_type,
                    "is a text (expected: {}); write {} = {} without quotes",
                    key.values.type, key.name, *meant);
    if (const auto text = node.value<std::string>();
        text && has_dates(bound.value))
        if (text->size() == 10 && text->at(4) == '-' && text->at(7) == '-')
            return fail(out_of_range,
                        "is {} (the calendar has no such day); use another day",
                        *text);
    const std::string example = example_of(bound);
    if (const auto number = node.value<double>();
        number && !std::isfinite(*number))
        return fail(wrong_type,
                    "is {} (not a finite number; expected: {}); write for "
                    "example {} = {}",
                    *number, key.values.type, key.name, example);
    fail(wrong_type, "is {} (expected: {}); write for example {} = {}",
         kind(node), key.values.type, key.name, example);
}

//! Describes the fault of a number; returns "" if it is valid.
std::string ValueFaults::fault(double value) const {
    const std::string unit = with_unit(key);
    if (!std::isfinite(value))
        return fmt::format(
            "is {} (not a finite number); give a number{}", value,
            key.values.lower == key.values.upper ? std::string()
                                                 : " in " + range_text(key));
    if (key.values.lower == key.values.upper) return "";
    if (value < key.values.lower)
        return fmt::format("is {}{} (below the range {}); use {}{} or more",
                           value, unit, range_text(key), key.values.lower,
                           unit);
    if (value > key.values.upper)
        return fmt::format("is {}{} (above the range {}); use {}{} or less",
                           value, unit, range_text(key), key.values.upper,
                           unit);
    return "";
}

//! Reports a number that would be in range in another unit. It is reported once
//! per file, since other entries probably use the same unit.
bool ValueFaults::is_mistaken(double value) const {
    if (!(value > key.values.upper)) return false;
    std::vector<std::string> units, values;
    for (const auto& [unit, in_ours] : key.values.mistaken) {
        if (!unit) continue;
        const double meant = value * in_ours;
        if (meant < key.values.lower || meant > key.values.upper) continue;
        units.emplace_back(unit);
        values.push_back(fmt::format("{:.6g}", meant));
    }
    if (units.empty()) return false;
    const bool is_length = std::string_view(key.values.unit) == "m";
    problems.add_once(
        key.name, name(), out_of_range,
        fmt::format(
            "{} is {}{} (above the range {}, it looks like {}); give {}: {}{}",
            name(), value, with_unit(key), range_text(key),
            fmt::join(units, " or "), is_length ? "metres" : "a fraction",
            fmt::join(values, " or "),
            is_length ? ", and check all lengths of this file" : ""));
    return true;
}

bool ValueFaults::accepts(double value) const {
    if (is_mistaken(value)) return false;
    const std::string why = fault(value);
    if (!why.empty()) fail(out_of_range, "{}", why);
    return why.empty();
}

}  // namespace ideotype
