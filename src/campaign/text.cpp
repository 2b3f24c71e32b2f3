// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "keys.hpp"
#include "schema.hpp"

namespace ideotype {

namespace {

//! As a TOML string.
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

//! Writes the value that a target points at.
struct Writer {
    const Key& key;

    std::string operator()(std::monostate) const { return ""; }
    std::string operator()(const std::string* text) const {
        return quoted(*text);
    }
    std::string operator()(const double* number) const {
        if (key.notation == Notation::clock) {
            // TOML's days end before that.
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
        std::vector<std::string> texts;
        for (const Date& date : *dates) texts.push_back(to_string(date));
        const std::string all = fmt::format("{}", fmt::join(texts, ", "));
        return texts.size() == 1 ? all : '[' + all + ']';
    }
    std::string operator()(const Date* date) const { return to_string(*date); }
    std::string operator()(const Range* range) const {
        return fmt::format("[{}, {}]", range->lower, range->upper);
    }
    std::string operator()(const std::vector<glm::dvec2>* points) const {
        std::vector<std::string> texts;
        for (const glm::dvec2& point : *points)
            texts.push_back(fmt::format("[{}, {}]", point.x, point.y));
        return fmt::format("[{}]", fmt::join(texts, ", "));
    }
    std::string operator()(const std::vector<double>* numbers) const {
        if (key.count == any_count && numbers->size() == 1)
            return fmt::format("{}", numbers->front());
        return fmt::format("[{}]", fmt::join(*numbers, ", "));
    }
    std::string operator()(const std::vector<std::string>* texts) const {
        if (texts->empty()) return "[]";
        if (key.count == any_count && texts->size() == 1)
            return quoted(texts->front());
        std::vector<std::string> all;
        for (const std::string& text : *texts) all.push_back(quoted(text));
        return fmt::format("[{}]", fmt::join(all, ", "));
    }
    std::string operator()(const Choice& choice) const {
        return quoted(choice.get());
    }
    template <class Plain>
    std::string operator()(const Plain* value) const {
        return fmt::format("{}", *value);
    }
};

struct TypeName {
    const Key& key;

    std::string operator()(std::monostate) const { return key.type; }
    std::string operator()(const std::string*) const { return "text"; }
    std::string operator()(const bool*) const { return "true or false"; }
    std::string operator()(const double*) const {
        if (key.notation == Notation::clock) return "local time";
        if (key.notation == Notation::duration)
            return "number or \"1h30m\" or \"HH:MM:SS\"";
        return "number";
    }
    std::string operator()(const std::optional<double>*) const {
        return "number";
    }
    std::string operator()(const std::optional<Column>*) const {
        return "[column, unit]";
    }
    std::string operator()(const Date*) const { return "local date"; }
    std::string operator()(const std::vector<Date>*) const {
        return "local date, or list of them";
    }
    std::string operator()(const Range*) const { return "[lower, upper]"; }
    std::string operator()(const std::vector<glm::dvec2>*) const {
        return "list of [out, up]";
    }
    std::string operator()(const std::vector<double>*) const {
        if (key.count == any_count) return "number or list by leaf";
        return key.count == 0 ? "list of numbers"
                              : fmt::format("list of {} numbers", key.count);
    }
    std::string operator()(const std::vector<std::string>*) const {
        return key.count == any_count ? "text or list of texts"
                                      : "list of texts";
    }
    std::string operator()(const Choice&) const { return "text"; }
    template <class Integer>
    std::string operator()(const Integer*) const {
        return "integer";
    }
};

KeyInfo describe(const Section& section, const Key& key) {
    KeyInfo info;
    info.section = section.name;
    info.name = key.name;
    info.type = type_text(key);
    info.unit = key.bounds.unit.empty() ? "-" : key.bounds.unit;
    Key unitless = key;
    unitless.bounds.unit.clear();
    info.range = range_text(unitless);
    if (key.is_required)
        info.initial = "required";
    else
        info.initial = key.initial.empty() ? toml_text(key) : key.initial;
    info.meaning = key.meaning;
    info.lower = key.bounds.lower;
    info.upper = key.bounds.upper;
    return info;
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

std::string type_text(const Key& key) {
    if (!key.type.empty()) return key.type;
    return std::visit(TypeName{key}, key.value);
}

std::string range_text(const Key& key) {
    if (!key.range.empty()) return key.range;
    if (!key.choices.empty())
        return fmt::format("\"{}\"", fmt::join(key.choices, "\" or \""));
    const auto& [lower, upper, unit] = key.bounds;
    if (lower == upper) return "-";
    return fmt::format("{} .. {}{}{}", lower, upper, unit.empty() ? "" : " ",
                       unit);
}

std::vector<KeyInfo> campaign_keys() {
    Draft draft;
    std::vector<KeyInfo> keys;
    const auto add = [&](const Section& section) {
        for (const Key& key : section.keys)
            keys.push_back(describe(section, key));
    };
    const auto add_table = [&](const Table& table) {
        if (table.resize) table.resize(1);
        add(table.section(0));
    };
    add(top_section(draft.campaign));
    // One trait stands for all.
    draft.traits.resize(1);
    draft.traits[0].trait.name = "TRAIT";
    draft.traits[0].sets = {};
    draft.rule.clear();
    draft.own_bounds = {draft.traits[0].trait.range};
    draft.campaign.constraints.traits = {{"TRAIT"}};
    for (const Table& table : campaign_tables(draft)) {
        add_table(table);
        for (const Table& child : table.children) add_table(child);
    }
    add(plant_file_section(draft.campaign.crop.baseline));
    for (const Table& table : plant_tables(draft)) add_table(table);
    return keys;
}

}  // namespace ideotype
