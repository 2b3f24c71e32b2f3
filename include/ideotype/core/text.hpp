// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ideotype/core/contract.hpp"

namespace ideotype {

//! Returns the longest start of a text that fits into a number of bytes, cut
//! between two UTF-8 characters.
std::string first_bytes(const std::string& text, std::size_t size);

//! Returns the number of characters of a UTF-8 text, each of which takes one
//! column of a terminal.
std::size_t columns_of(std::string_view text);

//! Returns a text of unknown origin as one harmless line for a terminal:
//! control characters, and bytes that are not UTF-8, are written as a
//! backslash, an x and two hexadecimal digits.
std::string printable(const std::string& text);

//! Returns a text of unknown origin as printable() does, but keeps its lines
//! and tabs.
std::string printable_lines(const std::string& text);

//! One entry of a line of a table.
struct CsvField {
    std::string_view text;  //!< entry without the blanks and quotes around it
    int column = 0;         //!< column of its first character, from 1
};

//! Returns the lines of a text, without the characters that end them.
std::vector<std::string_view> lines_of(std::string_view text);

//! Returns the entries of a line between commas; a comma within quotes ends no
//! entry.
std::vector<CsvField> fields_of(std::string_view line);

//! Returns the number that a text consists of, or nothing if it has anything
//! else.
std::optional<double> number_of(std::string_view text);

//! Reads a text from left to right. Each function removes a match from the
//! front of the text, or leaves the text as it is.
class Scanner {
  public:
    explicit Scanner(std::string_view text) : text_(text) {}

    std::string_view rest() const { return text_; }
    bool is_at_end() const { return text_.empty(); }

    //! Takes the next character if it is any of those given.
    bool take(std::string_view any) {
        if (text_.empty() || any.find(text_.front()) == any.npos) return false;
        text_.remove_prefix(1);
        return true;
    }

    //! Takes all digits that come next if their number is within two limits.
    //! @returns the digits as they are written
    std::optional<std::string_view> digits(std::size_t least,
                                           std::size_t most) {
        IDEOTYPE_EXPECT(least <= most);
        std::size_t count = text_.find_first_not_of("0123456789");
        if (count == text_.npos) count = text_.size();
        if (count < least || count > most) return {};
        const std::string_view found = text_.substr(0, count);
        text_.remove_prefix(count);
        return found;
    }

    //! Takes a whole number, if the number of its digits is within two limits.
    std::optional<int> number(std::size_t least, std::size_t most) {
        IDEOTYPE_EXPECT(most <= 9);
        const auto found = digits(least, most);
        if (!found) return {};
        int value = 0;
        for (const char digit : *found) value = 10 * value + (digit - '0');
        return value;
    }

  private:
    std::string_view text_;
};

}  // namespace ideotype
