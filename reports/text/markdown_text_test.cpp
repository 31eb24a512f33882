// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/text/markdown_text.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "reports/record/test_records.h"

namespace stiction {
namespace {

TEST(MarkdownEscaped, PlainTextStaysReadable) {
  for (const char* text : {"tan θ = μ", "mu=0.3/azimuth=30", "state_hash and v_0", "d = v₀²/(2g)",
                           "2.5 m", "fixed-point", "50, 90 and 99 %"}) {
    EXPECT_EQ(markdown_escaped(text), text);
  }
}

TEST(MarkdownEscaped, MarkupIsShownNotObeyed) {
  EXPECT_EQ(markdown_escaped("<script>&amp;"), "&lt;script&gt;&amp;amp;");
  EXPECT_EQ(markdown_escaped("a|b"), "a\\|b");
  EXPECT_EQ(markdown_escaped("a\\|b"), "a\\\\\\|b");
  EXPECT_EQ(markdown_escaped("*x* _y_ `z` ~w~ $u$"), "\\*x\\* \\_y\\_ \\`z\\` \\~w\\~ \\$u\\$");
  EXPECT_EQ(markdown_escaped("![i](http://e)"), "!\\[i\\](http://e)");
  EXPECT_EQ(markdown_escaped("a\n\n# b"), "a  # b");
}

TEST(MarkdownEscaped, BlockMarksAtTheStart) {
  EXPECT_EQ(markdown_escaped("# h"), "\\# h");
  EXPECT_EQ(markdown_escaped("- i"), "\\- i");
  EXPECT_EQ(markdown_escaped("> q"), "&gt; q");
  EXPECT_EQ(markdown_escaped("12. i"), "12\\. i");
  EXPECT_EQ(markdown_escaped("12) i"), "12\\) i");
  EXPECT_EQ(markdown_escaped("a - b"), "a - b");
}

TEST(MarkdownTable, PadsAndLeavesOutEmptyColumns) {
  MarkdownTable table({{"case"}, {"value", MarkdownTable::Align::kRight}, {"worst"}});
  table.add_row({"μ", "1", ""});
  table.add_row({"mu=0.3", "22.5", ""});
  EXPECT_EQ(table.text(),
            "| case   | value |\n"
            "| ------ | ----: |\n"
            "| μ      |     1 |\n"
            "| mu=0.3 |  22.5 |\n\n");
}

TEST(MarkdownTable, NoRowsNoTable) { EXPECT_EQ(MarkdownTable({{"case"}}).text(), ""); }

TEST(MarkdownTable, ARowOfAnotherLengthIsRefused) {
  MarkdownTable table({{"case"}, {"value"}});
  EXPECT_THROW(table.add_row({"a"}), std::invalid_argument);
}

}  // namespace
}  // namespace stiction
