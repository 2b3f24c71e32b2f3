// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/csv.hpp"

#include <charconv>

namespace ideotype {

namespace {

CsvField trimmed(std::string_view line, std::size_t begin, std::size_t end) {
    constexpr std::string_view around = " \t\"";
    std::string_view text = line.substr(begin, end - begin);
    const std::size_t first = text.find_first_not_of(around);
    if (first == text.npos) return {{}, static_cast<int>(begin) + 1};
    text = text.substr(first, text.find_last_not_of(around) - first + 1);
    return {text, static_cast<int>(begin + first) + 1};
}

}  // namespace

std::vector<std::string_view> lines_of(std::string_view text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark))
        text.remove_prefix(byte_order_mark.size());
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        std::string_view line = text.substr(0, end);
        if (line.ends_with('\r')) line.remove_suffix(1);
        lines.push_back(line);
        text.remove_prefix(end == text.npos ? text.size() : end + 1);
    }
    return lines;
}

std::vector<CsvField> fields_of(std::string_view line) {
    std::vector<CsvField> fields;
    std::size_t begin = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') quoted = !quoted;
        if (line[i] != ',' || quoted) continue;
        fields.push_back(trimmed(line, begin, i));
        begin = i + 1;
    }
    fields.push_back(trimmed(line, begin, line.size()));
    return fields;
}

std::optional<double> number_of(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc{} || rest != end) return std::nullopt;
    return number;
}

}  // namespace ideotype
