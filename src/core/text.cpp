// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/text.hpp"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

bool is_continuation(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

//! Returns the number of bytes of the first character; 0 if it is a control
//! character or not UTF-8.
std::size_t measure_character(std::string_view text) {
    IDEOTYPE_EXPECT(!text.empty());
    const auto byte = [&](std::size_t i) {
        return static_cast<unsigned char>(text[i]);
    };
    if (byte(0) < 0x80) return byte(0) < 0x20 || byte(0) == 0x7F ? 0 : 1;
    if (byte(0) < 0xC2 || byte(0) > 0xF4) return 0;
    const std::size_t size = byte(0) < 0xE0 ? 2 : byte(0) < 0xF0 ? 3 : 4;
    if (text.size() < size) return 0;
    for (std::size_t i = 1; i < size; ++i)
        if (!is_continuation(text[i])) return 0;
    // Terminals also take U+0080 to U+009F for control characters.
    return byte(0) == 0xC2 && byte(1) < 0xA0 ? 0 : size;
}

std::string escape_controls(std::string_view text, std::string_view kept) {
    std::string shown;
    while (!text.empty()) {
        const bool is_kept = kept.find(text[0]) != kept.npos;
        const std::size_t size = is_kept ? 1 : measure_character(text);
        if (size == 0)
            shown +=
                fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
        else
            shown += text.substr(0, size);
        text.remove_prefix(size == 0 ? 1 : size);
    }
    return shown;
}

CsvField trim(std::string_view line, std::size_t begin, std::size_t end) {
    constexpr std::string_view around = " \t\"";
    std::string_view text = line.substr(begin, end - begin);
    const std::size_t first = text.find_first_not_of(around);
    if (first == text.npos) return {{}, static_cast<int>(begin) + 1};
    text = text.substr(first, text.find_last_not_of(around) - first + 1);
    return {text, static_cast<int>(begin + first) + 1};
}

}  // namespace

std::string first_bytes(const std::string& text, std::size_t size) {
    if (text.size() <= size) return text;
    std::size_t end = size;
    while (end > 0 && is_continuation(text[end])) --end;
    return text.substr(0, end);
}

std::size_t count_columns(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::count_if(
        text, [](char byte) { return !is_continuation(byte); }));
}

std::string printable(const std::string& text) {
    return escape_controls(text, "");
}

std::string printable_lines(const std::string& text) {
    return escape_controls(text, "\n\t");
}

std::vector<std::string_view> split_lines(std::string_view text) {
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

std::vector<CsvField> split_fields(std::string_view line) {
    std::vector<CsvField> fields;
    std::size_t begin = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') quoted = !quoted;
        if (line[i] != ',' || quoted) continue;
        fields.push_back(trim(line, begin, i));
        begin = i + 1;
    }
    fields.push_back(trim(line, begin, line.size()));
    return fields;
}

std::optional<double> parse_number(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc{} || rest != end) return std::nullopt;
    return number;
}

}  // namespace ideotype
