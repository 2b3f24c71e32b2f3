// SPDX-License-Identifier: Apache-2.0
#include "writer.hpp"

#include <cmath>
#include <functional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "spec/tables.hpp"

namespace ideotype {

namespace {

std::string quoted(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 0x20 || code == 0x7f)
            escaped += fmt::format("\\u{:04X}", code);
        else if (c == '"' || c == '\\')
            escaped += fmt::format("\\{}", c);
        else
            escaped += c;
    }
    return '"' + escaped + '"';
}

//! Returns the texts of values, separated by commas.
std::string listed(const auto& values, const auto& text_of) {
    std::vector<std::string> texts;
    for (const auto& each : values) texts.push_back(text_of(each));
    return fmt::format("{}", fmt::join(texts, ", "));
}

//! Formats the value that a target points to as TOML.
struct Writer {
    const Key& key;

    std::string operator()(std::monostate) const { return ""; }
    std::string operator()(const std::string* text) const {
        return quoted(*text);
    }
    std::string operator()(const double* number) const {
        if (key.values.form == Form::clock) {
            // TOML has no time 24:00:00.
            const std::string text = clock_text(*number);
            return *number < 24 ? text : quoted(text);
        }
        return fmt::format("{}", *number);
    }
    template <class Value>
    std::string operator()(const std::optional<Value>* value) const {
        return *value ? (*this)(&**value) : "";
    }
    std::string operator()(const Column* column) const {
        return fmt::format("[{}, {}]", quoted(column->name),
                           quoted(column->unit));
    }
    std::string operator()(const std::vector<Date>* dates) const {
        const std::string text =
            listed(*dates, [](const Date& date) { return to_string(date); });
        return dates->size() == 1 ? text : '[' + text + ']';
    }
    std::string operator()(const Date* date) const { return to_string(*date); }
    std::string operator()(const Range* range) const {
        return fmt::format("[{}, {}]", range->lower, range->upper);
    }
    std::string operator()(const std::vector<glm::dvec2>* points) const {
        return '[' +
               listed(*points,
                      [](const glm::dvec2& point) {
                          return fmt::format("[{}, {}]", point.x, point.y);
                      }) +
               ']';
    }
    std::string operator()(const std::vector<double>* numbers) const {
        if (key.values.count == any_count && numbers->size() == 1)
            return fmt::format("{}", numbers->front());
        return fmt::format("[{}]", fmt::join(*numbers, ", "));
    }
    std::string operator()(const std::vector<std::string>* texts) const {
        const std::string text = listed(*texts, quoted);
        return key.values.count == any_count && texts->size() == 1
                   ? text
                   : '[' + text + ']';
    }
    std::string operator()(const std::vector<TomlValue>* values) const {
        return '[' + listed(*values, std::mem_fn(&TomlValue::text)) + ']';
    }
    std::string operator()(const Choice& choice) const {
        const std::string name = choice.get(choice.value);
        return name.empty() ? "" : quoted(name);
    }
    template <class Plain>
    std::string operator()(const Plain* value) const {
        return fmt::format("{}", *value);
    }
};

//! Returns the value of a numeric key.
double number_of(const BoundKey& key) {
    if (const auto* whole = std::get_if<int*>(&key.value)) return **whole;
    if (const auto* whole = std::get_if<std::optional<int>*>(&key.value))
        return (*whole)->value();
    if (const auto* any = std::get_if<std::optional<double>*>(&key.value))
        return (*any)->value();
    return *std::get<double*>(key.value);
}

//! Returns whether there is no value to write.
bool is_empty(const BoundKey& key) {
    return std::visit(
        [&](const auto& value) {
            using Value = std::remove_cvref_t<decltype(value)>;
            if constexpr (std::is_same_v<Value, std::monostate>)
                return true;
            else if constexpr (std::is_same_v<Value, Choice>)
                return value.get(value.value).empty();
            else if constexpr (requires { value->has_value(); })
                return !value->has_value();
            else if constexpr (!std::is_same_v<Value,
                                               std::vector<std::string>*> &&
                               requires { value->empty(); })
                return value->empty() && !key.key.initial.is_required;
            else
                return false;
        },
        key.value);
}

//! Returns a key with the address of its value in a record. The address is not
//! const, but the record is not changed.
BoundKey bound_to(const Key& key, const void* record) {
    return {key, key.place(const_cast<void*>(record))};
}

std::string text_of(const Key& key, const void* record) {
    return toml_text(bound_to(key, record));
}

//! Returns one line for each key of a record that texts contain.
//! @param is_short whether all keys with their defaults are omitted, not only
//! quiet ones
std::string key_lines(const Description& description, const void* record,
                      bool is_short = false) {
    std::string text;
    for (const Key& key : description.keys()) {
        const BoundKey bound = bound_to(key, record);
        if (is_empty(bound) || (key.is_written && !key.is_written(record)))
            continue;
        const std::string value = toml_text(bound);
        if (!(is_short || key.is_quiet) ||
            value != text_of(key, description.usual()))
            text += fmt::format("{} = {}\n", key.name, value);
    }
    return text;
}

//! Returns the text of a record's tables; `prefix` precedes their names.
std::string table_texts(const std::string& prefix,
                        const Description& description, const void* record);

std::string table_text(const std::string& prefix, const Table& table,
                       const void* parent) {
    if (table.is_written && !table.is_written(parent)) return "";
    if (table.text) return table.text(parent, prefix + table.name);
    std::string text;
    for (std::size_t i = 0; i < table.size(parent); ++i) {
        const void* const record = table.at(const_cast<void*>(parent), i);
        if (table.is_entry_written && !table.is_entry_written(record)) continue;
        const std::string name =
            prefix + (table.entry_name ? table.entry_name(record) : table.name);
        text += table.is_list ? "\n[[" + name + "]]\n" : "\n[" + name + "]\n";
        text += key_lines(*table.description, record) +
                table_texts(name + '.', *table.description, record);
    }
    return text;
}

std::string table_texts(const std::string& prefix,
                        const Description& description, const void* record) {
    std::string text;
    for (const Table& table : description.tables())
        text += table_text(prefix, table, record);
    return text;
}

std::string plant_text(const std::string& prefix, const CropSpec& crop) {
    return key_lines(crop_table, &crop) +
           table_texts(prefix, crop_table, &crop);
}

std::string crop_text(const std::string& prefix, const CropSpec& crop) {
    return plant_text(prefix, crop) +
           table_texts(prefix, crop_leaves_table, &crop);
}

}  // namespace

std::string baseline_text(const CropSpec& crop, const std::string& name) {
    return "\n[" + name + "]\n" + plant_text(name + '.', crop);
}

std::string component_crop_text(const CropSpec& crop, const std::string& name) {
    // A component without a known crop is a mesh.
    if (!crop.is_known) return "";
    return "\n[" + name + "]\n" + crop_text(name + '.', crop);
}

std::string own_bounds_text(const CropSpec& crop, const std::string& name) {
    if (!crop.rule.empty()) return "";
    std::string text = "\n[" + name + "]\n";
    for (std::size_t t = 0; t < crop.traits.size(); ++t)
        text += fmt::format(
            "{} = {}\n", crop.traits[t].trait.name,
            text_of(own_bounds_table.keys().front(), &crop.own_bounds.at(t)));
    return text;
}

std::string clock_text(double hours) {
    const long long total = std::llround(hours * 3.6e12);
    const long long nanoseconds = total % 1'000'000'000;
    const long long seconds = total / 1'000'000'000;
    std::string text = fmt::format("{:02}:{:02}:{:02}", seconds / 3600,
                                   seconds / 60 % 60, seconds % 60);
    if (nanoseconds != 0) text += fmt::format(".{:09}", nanoseconds);
    return text;
}

std::string toml_text(const BoundKey& key) {
    return std::visit(Writer{key.key}, key.value);
}

std::string range_text(const Key& key) {
    const Values& values = key.values;
    if (values.range) return values.range;
    const std::vector<std::string> texts = allowed_texts(key, {});
    if (!texts.empty())
        return fmt::format("\"{}\"", fmt::join(texts, "\" or \""));
    if (values.lower == values.upper) return "-";
    return fmt::format("{} .. {}{}{}", values.lower, values.upper,
                       *values.unit ? " " : "", values.unit);
}

std::string default_text(const Key& key, const void* usual) {
    if (key.initial.is_required) return "required";
    if (key.initial.words) return key.initial.words;
    const std::string text = text_of(key, usual);
    return text.empty() ? "[]" : text;
}

std::string changed_keys(const Description& description, const void* record) {
    return key_lines(description, record, true);
}

std::string resolved_text(const Spec& spec) {
    return key_lines(spec_table, &spec) + table_texts("", spec_table, &spec);
}

std::string crop_file_text(const CropSpec& crop) {
    return crop_text("", crop);
}

std::vector<AccuracyKey> accuracy_keys(const Spec& spec) {
    std::vector<AccuracyKey> keys;
    for (const Table& table : spec_table.tables()) {
        if (table.size(&spec) != 1) continue;
        const void* const record = table.at(const_cast<Spec*>(&spec), 0);
        for (const Key& key : table.description->keys()) {
            if (key.trial[0] == 0 || (key.has_trial && !key.has_trial(record)))
                continue;
            std::vector<double> values(key.trial.begin(), key.trial.end());
            std::erase(values, 0.);
            keys.push_back({fmt::format("{}.{}", table.name, key.name),
                            number_of(bound_to(key, record)), values});
        }
    }
    return keys;
}

}  // namespace ideotype
