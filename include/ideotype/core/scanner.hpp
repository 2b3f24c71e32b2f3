// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace ideotype {

//! Reads a text from the left to the right. Each function takes what it finds
//! off the text, or leaves the text as it is.
class Scanner {
  public:
    explicit Scanner(std::string_view text) : text_(text) {}

    std::string_view rest() const { return text_; }
    bool is_at_end() const { return text_.empty(); }

    //! Takes one character, which may be any of these.
    bool take(std::string_view any) {
        if (text_.empty() || any.find(text_.front()) == any.npos) return false;
        text_.remove_prefix(1);
        return true;
    }

    //! Takes all digits that come next, if there are so many.
    //! @returns the digits as they are written
    std::optional<std::string_view> digits(std::size_t least,
                                           std::size_t most) {
        std::size_t count = text_.find_first_not_of("0123456789");
        if (count == text_.npos) count = text_.size();
        if (count < least || count > most) return {};
        const std::string_view found = text_.substr(0, count);
        text_.remove_prefix(count);
        return found;
    }

    //! Takes a number of so many digits, at most nine.
    std::optional<int> number(std::size_t least, std::size_t most) {
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
