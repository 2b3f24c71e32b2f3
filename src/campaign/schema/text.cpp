// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "schema.hpp"
#include "table_texts.hpp"

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

//! Returns the texts of values between commas.
std::string listed(const auto& values, const auto& text_of) {
    std::vector<std::string> texts;
    for (const auto& each : values) texts.push_back(text_of(each));
    return fmt::format("{}", fmt::join(texts, ", "));
}

//! Writes the value that a target points at.
struct Writer {
    const Key& key;

    std::string operator()(std::monostate) const { return ""; }
    std::string operator()(const std::string* text) const {
        return quoted(*text);
    }
    std::string operator()(const double* number) const {
        if (key.is_clock()) {
            // Days of TOML end before 24:00:00.
            const std::string text = clock_text(*number);
            return *number < 24 ? text : quoted(text);
        }
        return fmt::format("{}", *number);
    }
    std::string operator()(const std::optional<double>* number) const {
        return *number ? fmt::format("{}", **number) : "";
    }
    std::string operator()(const std::optional<Column>* column) const {
        if (!*column) return "";
        return fmt::format("[{}, {}]", quoted((*column)->name),
                           quoted((*column)->unit));
    }
    std::string operator()(const std::vector<Date>* dates) const {
        const std::string all =
            listed(*dates, [](const Date& date) { return to_string(date); });
        return dates->size() == 1 ? all : '[' + all + ']';
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
        if (key.count == any_count && numbers->size() == 1)
            return fmt::format("{}", numbers->front());
        return fmt::format("[{}]", fmt::join(*numbers, ", "));
    }
    std::string operator()(const std::vector<std::string>* texts) const {
        const std::string all = listed(*texts, quoted);
        return key.count == any_count && texts->size() == 1 ? all
                                                            : '[' + all + ']';
    }
    std::string operator()(const Choice& choice) const {
        return quoted(choice.get());
    }
    template <class Plain>
    std::string operator()(const Plain* value) const {
        return fmt::format("{}", *value);
    }
};

//! Returns whether a key may be left out: it has no value or a form of its own.
bool is_empty(const Key& key) {
    if (!key.is_written) return true;
    return std::visit(
        [&](const auto& value) {
            using Value = std::remove_cvref_t<decltype(value)>;
            if constexpr (std::is_same_v<Value, std::monostate>)
                return true;
            else if constexpr (requires { value->has_value(); })
                return !value->has_value();
            else if constexpr (!std::is_same_v<Value,
                                               std::vector<std::string>*> &&
                               requires { value->empty(); })
                return value->empty() && !key.is_required;
            else
                return false;
        },
        key.value);
}

void append_keys(std::string& text, const Section& section) {
    for (const Key& key : section.keys)
        if (!is_empty(key))
            text += fmt::format("{} = {}\n", key.name, toml_text(key));
}

//! Returns the keys of a section that have other values than in a section of
//! the same keys, one a line.
std::string changed_keys(const Section& section, const Section& usual) {
    std::string text;
    for (std::size_t i = 0; i < section.keys.size(); ++i) {
        const Key& key = section.keys[i];
        if (!is_empty(key) && toml_text(key) != toml_text(usual.keys.at(i)))
            text += fmt::format("{} = {}\n", key.name, toml_text(key));
    }
    return text;
}

//! Appends a table under a name with the prefix of the tables of its file.
void append_table(std::string& text, const std::string& prefix,
                  const Table& table) {
    if (table.is_default) return;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const std::string name = prefix + table.name;
        text += table.resize ? "\n[[" + name + "]]\n" : "\n[" + name + "]\n";
        append_keys(text, table.section(i));
    }
    for (const Table& child : table.children)
        append_table(text, prefix + table.name + '.', child);
}

void append_plant(std::string& text, const std::string& prefix, Draft& draft) {
    append_keys(text, plant_file_section(draft.campaign.crop.baseline));
    for (const Table& table : plant_tables(draft))
        append_table(text, prefix, table);
}

void append_crop(std::string& text, const std::string& prefix, Draft& draft) {
    append_plant(text, prefix, draft);
    for (const Table& table : crop_defaults(draft))
        append_table(text, prefix, table);
}

void append_components(std::string& text, const Table& components,
                       Draft& draft) {
    for (std::size_t i = 0; i < draft.components.size(); ++i) {
        Draft& component = *draft.components[i];
        text += "\n[[component]]\n";
        append_keys(text, components.section(i));
        if (component.has_variation) {
            text += "\n[component.variation]\n";
            append_keys(text,
                        variation_section(component.campaign.field.variation,
                                          "component.variation"));
        }
        text += "\n[component.crop]\n";
        append_crop(text, "component.crop.", component);
        if (component.rule.empty())
            append_table(text, "component.",
                         own_bounds_table(component, "component"));
    }
}

}  // namespace

std::string clock_text(double hours) {
    const long long total = std::llround(hours * 3.6e12);
    const long long nanoseconds = total % 1'000'000'000;
    const long long seconds = total / 1'000'000'000;
    std::string text = fmt::format("{:02}:{:02}:{:02}", seconds / 3600,
                                   seconds / 60 % 60, seconds % 60);
    if (nanoseconds != 0) text += fmt::format(".{:09}", nanoseconds);
    return text;
}

std::string toml_text(const Key& key) {
    return std::visit(Writer{key}, key.value);
}

std::string climate_keys(const Named<Climate>& climate) {
    Named<Climate> own = climate, usual;
    // The dates have no default.
    usual.value.period = {{1, 1, 1}, {1, 1, 1}};
    return changed_keys(climate_section(own), climate_section(usual));
}

std::string variation_keys(const PlantVariation& variation) {
    PlantVariation own = variation, usual;
    return changed_keys(variation_section(own, "field.variation"),
                        variation_section(usual, "field.variation"));
}

std::string fault_of(double value, const std::string& table,
                     const std::string& key) {
    Draft draft;
    for (const Table& each : campaign_tables(draft)) {
        if (each.name != table) continue;
        each.resize(1);
        Section section = each.section(0);
        return fault_of(value, table, section[key]);
    }
    return "";
}

std::string range_text(const Key& key) {
    if (!key.range.empty()) return key.range;
    if (!key.choices.empty())
        return fmt::format("\"{}\"", fmt::join(key.choices, "\" or \""));
    if (key.lower == key.upper) return "-";
    return fmt::format("{} .. {}{}{}", key.lower, key.upper,
                       key.unit.empty() ? "" : " ", key.unit);
}

std::string resolved_text(Draft& draft) {
    std::string text;
    append_keys(text, top_section(draft.campaign));
    for (const Table& table : campaign_tables(draft)) {
        if (table.name == "component") {
            append_components(text, table, draft);
            continue;
        }
        // A study has no search.
        if (!draft.is_study || table.name != "search")
            append_table(text, "", table);
        if (table.name != "plant") continue;
        text += "\n[plant.baseline]\n";
        append_plant(text, "plant.baseline.", draft);
    }
    return text;
}

std::vector<AccuracyKey> accuracy_keys(Draft& draft) {
    std::vector<AccuracyKey> found;
    for (const Table& table : campaign_tables(draft)) {
        if (table.size() != 1) continue;
        for (const Key& key : table.section(0).keys) {
            if (key.accuracy.empty()) continue;
            const auto* const whole = std::get_if<int*>(&key.value);
            found.push_back({table.name + '.' + key.name,
                             whole ? **whole : *std::get<double*>(key.value),
                             key.accuracy});
        }
    }
    return found;
}

std::string resolved_plant_text(Draft& draft) {
    std::string text;
    append_crop(text, "", draft);
    return text;
}

}  // namespace ideotype
