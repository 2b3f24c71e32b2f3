// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ideotype/core/contract.hpp"

namespace ideotype {

//! Cuts a text to a number of bytes without splitting a UTF-8 character.
std::string first_bytes(const std::string& text, std::size_t size);

//! Counts the characters of a UTF-8 text, assuming one terminal column each.
std::size_t count_columns(std::string_view text);

//! Makes a text of unknown origin safe to print in one line of a terminal.
//! Control characters, and bytes that are not UTF-8, are replaced by a
//! backslash, an x and two hexadecimal digits.
std::string printable(const std::string& text);

//! Makes a text safe as printable() does, but keeps line breaks and tabs.
std::string printable_lines(const std::string& text);

//! An entry in a line of a table.
struct CsvField {
    std::string_view text;  //!< entry without surrounding blanks and quotes
    int column = 0;  //!< position of the first character of the entry, from 1
};

//! Splits a text into lines, without the characters that end them.
std::vector<std::string_view> split_lines(std::string_view text);

//! Splits a line at commas outside quotes.
std::vector<CsvField> split_fields(std::string_view line);

//! Parses a text as a number; returns nothing if the text contains anything
//! else.
std::optional<double> parse_number(std::string_view text);

//! Reads a text from left to right. Each function removes a match from the
//! front of the text, or leaves the text unchanged.
class Scanner {
  public:
    explicit Scanner(std::string_view text) : text_(text) {}

    std::string_view rest() const { return text_; }
    bool is_at_end() const { return text_.empty(); }

    //! Takes the next character if it is one of `characters`.
    bool take(std::string_view characters) {
        if (text_.empty() || characters.find(text_.front()) == characters.npos)
            return false;
        text_.remove_prefix(1);
        return true;
    }

    //! Takes the next digits if their number is within the given limits.
    //! @returns the digits as written
    std::optional<std::string_view> digits(std::size_t fewest,
                                           std::size_t limit) {
        IDEOTYPE_EXPECT(fewest <= limit);
        std::size_t count = text_.find_first_not_of("0123456789");
        if (count == text_.npos) count = text_.size();
        if (count < fewest || count > limit) return {};
        const std::string_view run = text_.substr(0, count);
        text_.remove_prefix(count);
        return run;
    }

    //! Takes a whole number if its number of digits is within the given limits.
    std::optional<int> number(std::size_t fewest, std::size_t limit) {
        IDEOTYPE_EXPECT(limit <= 9);
        const auto run = digits(fewest, limit);
        if (!run) return {};
        int value = 0;
        for (const char digit : *run) value = 10 * value + (digit - '0');
        return value;
    }

  private:
    std::string_view text_;
};

}  // namespace ideotype
