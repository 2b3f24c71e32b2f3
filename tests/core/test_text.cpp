// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "ideotype/core/text.hpp"

namespace ideotype {
namespace {

TEST(Text, TextIsCutBetweenCharacters) {
    EXPECT_EQ(first_bytes("K\u00f6ln", 2), "K");
    EXPECT_EQ(first_bytes("K\u00f6ln", 3), "K\u00f6");
    EXPECT_EQ(first_bytes("K\u00f6ln", 9), "K\u00f6ln");
}

TEST(Text, ColumnsAreCharactersRatherThanBytes) {
    EXPECT_EQ(count_columns(""), 0U);
    EXPECT_EQ(count_columns("1.5 \u00b1 0.1"), 9U);
}

TEST(Text, ControlCharactersAreEscaped) {
    EXPECT_EQ(printable("a\x1b[1Ab\a\x7f\r\n"),
              "a\\x1b[1Ab\\x07\\x7f\\x0d\\x0a");
    // U+009B begins a control sequence, encoded in UTF-8 or as a single byte.
    EXPECT_EQ(printable("\xc2\x9b"
                        "A\x9b"),
              "\\xc2\\x9bA\\x9b");
    EXPECT_EQ(printable("\xe2\x82"), "\\xe2\\x82");
    EXPECT_EQ(printable_lines("a\n\tb\x1b"), "a\n\tb\\x1b");
}

TEST(Text, TextInAnyLanguageIsUnchanged) {
    const std::string text = "K\u00f6ln \u20ac \U0001F33D";
    EXPECT_EQ(printable(text), text);
}

}  // namespace
}  // namespace ideotype
