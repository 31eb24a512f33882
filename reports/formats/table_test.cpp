// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/table.h"

#include <gtest/gtest.h>

#include <sstream>

#include "reports/formats/test_screen.h"
#include "reports/record/test_records.h"
#include "reports/text/text.h"

namespace stiction {
namespace {

using test::has;
using test::kWide;
using test::lines_of;

// Without its colours, a coloured text is the plain one.
std::string without_colours(const std::string& text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\x1b') {
      i = text.find('m', i);
    } else {
      plain += text[i];
    }
  }
  return plain;
}

TEST(Table, ALinePerCheckUnderItsCase) {
  const auto lines = lines_of(table_rows(test::failing_record(), kWide));
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_TRUE(lines[0].starts_with("incline/below/mu=0.3  paper, fixed point, kappa=0.7"));
  EXPECT_TRUE(lines[0].ends_with("41.5 of 325 ns"));
  EXPECT_TRUE(lines[1].starts_with("  FAIL     stopping distance [m]"));
  for (const char* part : {"0.31", "0.3", "0.01", "1.5", "100 ×"}) EXPECT_TRUE(has(lines[1], part));
  EXPECT_TRUE(lines[2].starts_with("  pass     critical slope, tan θ [1]"));
  EXPECT_TRUE(has(lines[2], "4e-05 rel"));
}

TEST(Table, LinesFitTheWidthAndNothingIsCut) {
  Record record = test::failing_record();
  record.checks[0].claim.quantity = "a quantity with a name that is far too long for its column";
  record.checks[1].value = -1.2345678e-30;
  record.checks[1].error = -1.234e-30;
  for (const std::size_t width : {77u, 80u, 95u, 96u, 100u, 140u, 200u}) {
    const Screen screen{.width = width};
    const auto header = lines_of(table_header(screen));
    const auto rows = lines_of(table_rows(record, screen));
    for (const auto& line : header) EXPECT_LE(display_width(line), width) << line;
    for (const auto& line : rows) EXPECT_LE(display_width(line), width) << line;
    EXPECT_EQ(display_width(rows[1]), display_width(header[1])) << width;
    std::istringstream words(table_rows(record, screen));
    std::string text;
    for (std::string word; words >> word;) text += word + " ";
    EXPECT_FALSE(has(text, "…"));
    for (const char* word : {"quantity", "far", "too", "long", "column", "[m]"}) {
      EXPECT_TRUE(has(text, word)) << width << ": " << word;
    }
  }
}

TEST(Table, TinyWidthsDoNotCrash) {
  for (const std::size_t width : {0u, 1u, 10u, 40u}) {
    const Screen screen{.width = width};
    EXPECT_TRUE(has(table_rows(test::failing_record(), screen), "FAIL"));
    EXPECT_TRUE(has(table_header(screen), "measured"));
  }
}

TEST(Table, ColourAddsOnlyColour) {
  const Screen plain{.width = 100};
  const Screen coloured{.width = 100, .colour = true};
  for (const Record& record : {test::failing_record(), test::passing_record(), test::error_record(),
                               test::not_applicable_record()}) {
    EXPECT_FALSE(has(table_rows(record, plain), "\x1b"));
    EXPECT_TRUE(has(table_rows(record, coloured), "\x1b["));
    EXPECT_EQ(without_colours(table_rows(record, coloured)), table_rows(record, plain));
  }
}

TEST(Table, ABandStandsBelowItsCheck) {
  for (const std::size_t width : {40u, 77u, 96u, 140u}) {
    const std::string rows = table_rows(test::refuted_record(), {width, false});
    EXPECT_TRUE(has(rows, "  refuted"));
    EXPECT_TRUE(has(rows, "as expected in")) << rows;
  }
  EXPECT_TRUE(has(table_rows(test::outside_record(0.30001), kWide), "raise the bar"));
}

TEST(Table, ARecordWithoutChecksSaysWhy) {
  EXPECT_TRUE(
      has(table_rows(test::error_record(), kWide), "ERROR    the time step 0.1 s is above"));
  EXPECT_TRUE(has(table_rows(test::not_applicable_record(), kWide),
                  "n/a      the engine has no deformable obstacles"));
  Record silent = test::not_applicable_record();
  silent.notes.clear();
  EXPECT_TRUE(has(table_rows(silent, kWide), "n/a      no checks"));
}

TEST(Table, TextFromRecordsCannotSteerTheTerminal) {
  const Record record = test::hostile_record();
  const std::string text = table_rows(record, kWide);
  EXPECT_FALSE(has(text, "\x1b"));
  EXPECT_EQ(text.find_first_of(std::string_view("\0\r\t", 3)), std::string::npos);
  EXPECT_TRUE(has(text, "nan"));
}

TEST(NotApplicable, TellsOnceWhatAnEngineLacks) {
  std::vector<Record> records(3, test::not_applicable_record());
  records[1].case_name = "stack/flush/n=2";
  EXPECT_EQ(not_applicable_block(records, kWide),
            "n/a      the engine has no deformable obstacles: slab/threshold (2), stack/flush\n");
  EXPECT_EQ(not_applicable_block({test::passing_record()}, kWide), "");
}

}  // namespace
}  // namespace stiction
