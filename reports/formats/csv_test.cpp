// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/csv.h"

#include <gtest/gtest.h>

#include <map>

#include "reports/record/test_records.h"
#include "reports/text/text.h"

namespace stiction {
namespace {

using Rows = std::vector<std::vector<std::string>>;

// RFC 4180 as a reader sees it.
Rows parsed(const std::string& csv) {
  Rows rows;
  std::vector<std::string> row(1);
  bool quoted = false;
  for (std::size_t i = 0; i < csv.size(); ++i) {
    const char c = csv[i];
    if (quoted) {
      if (c != '"') {
        row.back() += c;
      } else if (i + 1 < csv.size() && csv[i + 1] == '"') {
        row.back() += csv[++i];
      } else {
        quoted = false;
      }
    } else if (c == '"') {
      quoted = true;
    } else if (c == ',') {
      row.emplace_back();
    } else if (csv.compare(i, 2, "\r\n") == 0) {
      rows.push_back(row);
      row.assign(1, "");
      ++i;
    } else {
      row.back() += c;
    }
  }
  return rows;
}

// Cells of one row by the header's names.
std::map<std::string, std::string> named(const Rows& rows, std::size_t row) {
  std::map<std::string, std::string> cells;
  for (std::size_t i = 0; i < rows[0].size(); ++i) cells[rows[0][i]] = rows[row][i];
  return cells;
}

TEST(Csv, OneRowPerCheck) {
  const Rows rows = parsed(csv_table({test::failing_record(), test::passing_record()}));
  ASSERT_EQ(rows.size(), 4u);
  for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
  const auto first = named(rows, 1);
  EXPECT_EQ(first.at("case"), "incline/below/mu=0.3");
  EXPECT_EQ(first.at("case_verdict"), "fail");
  EXPECT_EQ(first.at("quantity"), "stopping distance");
  EXPECT_EQ(first.at("value"), "0.31");
  EXPECT_EQ(first.at("error"), "0.01");
  EXPECT_EQ(first.at("relative"), "false");
  EXPECT_EQ(first.at("verdict"), "fail");
  EXPECT_EQ(first.at("steps"), "12000");
  EXPECT_EQ(first.at("date"), "2025-11-20T23:41:05Z");
  const auto second = named(rows, 2);
  EXPECT_EQ(second.at("case_verdict"), "fail");
  EXPECT_EQ(second.at("verdict"), "pass");
  EXPECT_EQ(second.at("digits"), "4.4");
}

TEST(Csv, ABandHasTwoColumnsEmptyWithoutOne) {
  const Rows rows = parsed(csv_table({test::refuted_record()}));
  EXPECT_EQ(named(rows, 1).at("verdict"), "refuted");
  EXPECT_EQ(named(rows, 1).at("band_low"), "0.305");
  EXPECT_EQ(named(rows, 1).at("band_high"), "0.32");
  EXPECT_EQ(named(rows, 1).at("cause"), "normal forces never settle");
  EXPECT_EQ(named(rows, 2).at("band_low"), "");
}

TEST(Csv, ARecordWithoutChecksHasARow) {
  const Rows rows = parsed(csv_table({test::error_record()}));
  ASSERT_EQ(rows.size(), 2u);
  ASSERT_EQ(rows[1].size(), rows[0].size());
  const auto row = named(rows, 1);
  EXPECT_EQ(row.at("case_error"), test::error_record().error);
  EXPECT_EQ(row.at("value"), "");
  EXPECT_EQ(row.at("verdict"), "");
  EXPECT_EQ(row.at("machine"), "Example CPU, 2 cores");
}

TEST(Csv, AFigureHasARowWithoutAClaim) {
  Record record = test::compared_record();
  record.checks.clear();
  const Rows rows = parsed(csv_table({record}));
  ASSERT_EQ(rows.size(), 2u);
  const auto row = named(rows, 1);
  EXPECT_EQ(row.at("quantity"), "steps to 1e-9");
  EXPECT_EQ(row.at("claim"), "static friction is found again soon");
  EXPECT_EQ(row.at("value"), "12");
  EXPECT_EQ(row.at("expected"), "");
  EXPECT_EQ(row.at("verdict"), "");
}

TEST(Csv, AnEmptyFirstCellKeepsItsPlace) {
  Record record = test::passing_record("");
  record.checks[0].claim.quantity.clear();
  const Rows rows = parsed(csv_table({record}));
  ASSERT_EQ(rows[1].size(), rows[0].size());
  EXPECT_EQ(named(rows, 1).at("unit"), "1");
}

TEST(Csv, HostileTextIsOneLine) {
  const Rows rows = parsed(csv_table({test::hostile_record(), test::passing_record()}));
  const std::string text = one_line(test::hostile_text());
  ASSERT_EQ(rows.size(), 3u);
  ASSERT_EQ(rows[1].size(), rows[0].size());
  const auto row = named(rows, 1);
  EXPECT_EQ(row.at("title"), text);
  EXPECT_EQ(row.at("worst"), text);
  EXPECT_EQ(row.at("value"), "nan");
  EXPECT_EQ(row.at("error"), "nan");
  EXPECT_EQ(row.at("expected"), "inf");
}

TEST(Csv, EachSpecialCharacterAloneIsQuoted) {
  for (const char* text : {"a,b", "say \"μ\""}) {
    Record record = test::passing_record();
    record.title = text;
    const std::string csv = csv_table({record});
    EXPECT_EQ(named(parsed(csv), 1).at("title"), text);
    EXPECT_NE(csv.find(",\"" + std::string(1, text[0])), std::string::npos) << text;
  }
}

// A spreadsheet would compute it, or start a program (CWE-1236).
TEST(Csv, TextThatBeginsLikeAFormulaIsMarkedAsText) {
  for (const std::string text :
       {"=1+1", "+1", "-1", "@SUM(A1)", "\t=1", "\x1b=1", " =1", "\u200E=1"}) {
    Record record = test::error_record();
    record.title = record.error = record.engine = text;
    record.environment.machine = text;
    const auto row = named(parsed(csv_table({record})), 1);
    for (const char* const column : {"title", "case_error", "engine", "machine"}) {
      EXPECT_EQ(row.at(column), "'" + one_line(text)) << column;
    }
  }
  Record record = test::passing_record();
  record.title = "a - b = c";
  record.checks[0].value = -2.5;
  record.checks[0].claim.expected = -test::kInf;
  const auto row = named(parsed(csv_table({record})), 1);
  EXPECT_EQ(row.at("title"), "a - b = c");
  EXPECT_EQ(row.at("value"), "-2.5") << "a number stays one";
  EXPECT_EQ(row.at("expected"), "-inf");
}

TEST(Csv, NoRecordsIsAHeader) { EXPECT_EQ(parsed(csv_table({})).size(), 1u); }

}  // namespace
}  // namespace stiction
