// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/text/text.h"

#include <gtest/gtest.h>

namespace stiction {
namespace {

TEST(OneLine, LeavesPlainTextAlone) {
  const std::string text = "tan θ = μ ≤ 0.3 · v₀² 𝛍 <b> | \"q\"";
  EXPECT_EQ(one_line(text), text);
  EXPECT_EQ(one_line(""), "");
}

TEST(OneLine, BreaksAndControls) {
  EXPECT_EQ(one_line("a\nb\r\nc\td"), "a b c d");
  EXPECT_EQ(one_line(std::string("a\0b\x1b[2Jc\x7f", 9)), "ab[2Jc");
  EXPECT_EQ(one_line("a\u0085\u009b31m b"), "a31m b") << "C1 controls steer terminals as well";
  EXPECT_EQ(one_line("a\u2028b\u202Ec\uFFFE"), "a bc");
}

TEST(OneLine, NothingTurnsTheDirectionOfText) {
  for (const char* const sign : {"\u061C", "\u200E", "\u200F", "\u202A", "\u202B", "\u202C",
                                 "\u202D", "\u202E", "\u2066", "\u2067", "\u2068", "\u2069"}) {
    EXPECT_EQ(one_line(std::string("a") + sign + "b"), "ab");
  }
}

TEST(Printable, KeepsLinesAndDropsTheRest) {
  EXPECT_EQ(printable("a\nb\n"), "a\nb\n");
  EXPECT_EQ(printable("\n\na"), "\n\na");
  EXPECT_EQ(printable(std::string("a\r\nb\0\u202E\x1b]0;x\x07 c\td\xff", 20)),
            "a\nb]0;x c d\uFFFD");
}

// What was not given by bold() or a verdict is text, which could hide the text behind it.
TEST(Printable, StylesAreThoseOfThisProjectAndOnlyWhereAsked) {
  const std::string text = "\x1b[1mname\x1b[0m \x1b[1;31mFAIL\x1b[0m";
  EXPECT_EQ(printable(text, true), text);
  EXPECT_EQ(printable(text), "[1mname[0m [1;31mFAIL[0m");
  EXPECT_EQ(printable("\x1b[8mhidden \x1b[2Jaway \x1b", true), "[8mhidden [2Jaway ");
}

TEST(OneLine, BrokenUtf8IsReplacedByteByByte) {
  EXPECT_EQ(one_line("a\xff"
                     "b"),
            "a\uFFFDb");
  EXPECT_EQ(one_line("a\xce"), "a\uFFFD") << "cut off at the end";
  EXPECT_EQ(one_line("\xce"
                     "a"),
            "\uFFFDa")
      << "the byte behind is kept";
  EXPECT_EQ(one_line("\xc0\x80"), "\uFFFD\uFFFD") << "overlong NUL";
  EXPECT_EQ(one_line("\xe0\x80\x8a"), "\uFFFD\uFFFD\uFFFD") << "overlong line break";
  EXPECT_EQ(one_line("\xed\xa0\x80"), "\uFFFD\uFFFD\uFFFD") << "surrogate";
  EXPECT_EQ(one_line("\xf4\x90\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD") << "beyond Unicode";
  EXPECT_EQ(one_line("\x80"), "\uFFFD");
}

TEST(DisplayWidth, CountsColumns) {
  EXPECT_EQ(display_width(""), 0u);
  EXPECT_EQ(display_width("tan θ = μ"), 9u);
  EXPECT_EQ(display_width("x\u0308"), 1u) << "combining diaeresis: ẍ";
}

TEST(Shortened, KeepsBothEnds) {
  EXPECT_EQ(shortened("short", 5), "short");
  EXPECT_EQ(shortened("abcdefghij", 5), "ab…ij");
  EXPECT_EQ(shortened("abcdefghij", 4), "a…ij");
  EXPECT_EQ(shortened("αβγδεζηθικ", 5), "αβ…ικ");
  EXPECT_EQ(shortened("abc", 1), "…");
  EXPECT_EQ(shortened("abc", 0), "");
}

TEST(Padded, FillsToColumnsNotBytes) {
  EXPECT_EQ(padded_right("μ", 3), "μ  ");
  EXPECT_EQ(padded_left("μ", 3), "  μ");
  EXPECT_EQ(padded_left("abcd", 3), "abcd");
}

TEST(Wrapped, BreaksAtSpaces) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(wrapped("", 10), Lines{});
  EXPECT_EQ(wrapped("   ", 10), Lines{});
  EXPECT_EQ(wrapped("one two three", 7), (Lines{"one two", "three"}));
  EXPECT_EQ(wrapped("one  two", 3), (Lines{"one", "two"}));
  EXPECT_EQ(wrapped("a-very-long-word b", 4), (Lines{"a-very-long-word", "b"}));
  EXPECT_EQ(wrapped("μμ μμ", 5), (Lines{"μμ μμ"}));
}

}  // namespace
}  // namespace stiction
