// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ideotype/core/contract.hpp"

namespace ideotype {

//! Returns the start of a text that fits into this many bytes, cut between two
//! UTF-8 characters.
std::string first_bytes(const std::string& text, std::size_t size);

//! Returns a text of unknown origin as one line for a terminal, where it can do
//! no harm: control characters, and bytes that are not UTF-8, stand as a
//! backslash, an x and two hexadecimal digits.
std::string printable(const std::string& text);

//! Returns a text of unknown origin as printable() does, but keeps its lines
//! and tabs.
std::string printable_lines(const std::string& text);

//! One entry of a line of a table.
struct CsvField {
    std::string_view text;  //!< without blanks and quotes around it
    int column = 0;         //!< where it begins, from 1
};

//! Returns the lines of a text, without the characters that end them.
std::vector<std::string_view> lines_of(std::string_view text);

//! Returns the entries between commas; a comma within quotes ends none.
std::vector<CsvField> fields_of(std::string_view line);

//! Returns the number that a text consists of, or nothing if there is anything
//! else in it.
std::optional<double> number_of(std::string_view text);

//! Reads a text from the left to the right. Each function takes what it finds
//! off the text, or leaves the text as it is.
class Scanner {
  public:
    explicit Scanner(std::string_view text) : text_(text) {}

    std::string_view rest() const { return text_; }
    bool is_at_end() const { return text_.empty(); }

    //! Takes one character if it is any of these.
    bool take(std::string_view any) {
        if (text_.empty() || any.find(text_.front()) == any.npos) return false;
        text_.remove_prefix(1);
        return true;
    }

    //! Takes all digits that come next, if their number is within these limits.
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

    //! Takes a whole number, if the number of its digits is within these
    //! limits.
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
