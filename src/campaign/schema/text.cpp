// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "schema.hpp"

namespace ideotype {

namespace {

//! Returns a text as a TOML string.
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

std::string range_text(const Key& key) {
    if (!key.range.empty()) return key.range;
    if (!key.choices.empty())
        return fmt::format("\"{}\"", fmt::join(key.choices, "\" or \""));
    if (key.lower == key.upper) return "-";
    return fmt::format("{} .. {}{}{}", key.lower, key.upper,
                       key.unit.empty() ? "" : " ", key.unit);
}

}  // namespace ideotype
