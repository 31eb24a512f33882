// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/markdown.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "reports/formats/test_screen.h"
#include "reports/record/test_records.h"

namespace stiction {
namespace {

using test::has;

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

// Cell borders of a line: bars that no backslash escapes.
std::size_t borders(const std::string& line) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\\') {
      ++i;
    } else if (line[i] == '|') {
      ++count;
    }
  }
  return count;
}

TEST(MarkdownReport, SaysEverythingAboutACheck) {
  const std::string report = markdown_report({test::passing_record()});
  for (const char* part : {"1 pass, 0 fail",
                           "4f2a9c1+",
                           "g++ 12.2.0 release",
                           "Example CPU, 2 cores",
                           "2025-11-20T23:41:05Z",
                           "incline/threshold",
                           "mu=0.3/azimuth=30",
                           "A box sticks if and only if tan θ ≤ μ.",
                           "critical slope, tan θ",
                           "0.300012",
                           "4e-05 rel",
                           "4.4",
                           "0.0001 rel",
                           "tan θ_c = μ",
                           "analytic; Coulomb1785",
                           "half the bracket's width",
                           "upper end of the bracket",
                           "does not topple",
                           "12,000",
                           "96,000",
                           "41.5",
                           "0123456789abcdef",
                           "rule=fixed-point",
                           "kinetic energy over time"}) {
    EXPECT_TRUE(has(report, part)) << part;
  }
  EXPECT_FALSE(has(report, "What failed"));
}

TEST(MarkdownReport, FailuresComeFirst) {
  const std::string report = markdown_report(
      {test::passing_record("a/b/mu=1"), test::error_record(), test::failing_record("z/y")});
  const std::size_t families = report.find("## Overview");
  EXPECT_LT(report.find("### **FAIL**: z/y"), families);
  EXPECT_LT(report.find("vertex 17 at t = 0.42 s"), families);
  EXPECT_LT(report.find("v₀Δt/2, the bias of symplectic Euler"), families);
  EXPECT_LT(report.find("stability limit of element 3"), families);
  EXPECT_EQ(count_of(report, "### "), 2u) << "the passing record is not among the failures";
}

TEST(MarkdownReport, EqualTextsStandOnceInAFamily) {
  std::vector<Record> records;
  for (int i = 0; i < 150; ++i) {
    records.push_back(test::passing_record("incline/threshold/azimuth=" + std::to_string(i)));
  }
  const std::string report = markdown_report(records);
  for (const char* part : {"A box sticks if and only if", "tan θ_c = μ", "Coulomb1785",
                           "half the bracket's width", "does not topple"}) {
    EXPECT_EQ(count_of(report, part), 1u) << part;
  }
  EXPECT_EQ(count_of(report, "| azimuth="), 300u) << "a row of checks and a row of costs each";
  EXPECT_LT(report.find("| azimuth=9 "), report.find("| azimuth=10 "));
}

TEST(MarkdownReport, FiguresAndFailuresOfAComparison) {
  const std::string report = markdown_report({test::compared_record()}, "Compared");
  EXPECT_TRUE(has(report, "**Measured, not judged.**"));
  EXPECT_TRUE(has(report, "steps to 1e-9"));
  EXPECT_TRUE(has(report, "failed: a body left its place at gain = -0.5, 2.3"));
}

TEST(MarkdownReport, FewestDigitsAreThoseOfChecksThatPassOrFail) {
  Record record = test::passing_record();
  record.checks.push_back(test::shortfall_record().checks.front());
  record.checks.back().digits = 0.3;
  record.checks.push_back(test::failing_check());
  record.checks.back().digits.reset();
  EXPECT_TRUE(has(markdown_report({record}, ""), " 4.4 |"));
  EXPECT_EQ(fewest_digits(record), 4.4);
}

TEST(MarkdownReport, DifferingReasonsAndNotesAreToldApart) {
  std::vector<Record> records = {test::passing_record("incline/threshold/mu=0.1"),
                                 test::passing_record("incline/threshold/mu=0.3")};
  records[1].checks[0].claim.reason = "another derivation";
  records[1].notes = {"only here"};
  const std::string report = markdown_report(records);
  EXPECT_TRUE(has(report, "- Tolerance (a): half the bracket"));
  EXPECT_TRUE(has(report, "- Tolerance (b): another derivation"));
  EXPECT_TRUE(has(report, "0.0001 rel (b)"));
  EXPECT_TRUE(has(report, "- Note: only here (mu=0.3)"));
}

TEST(MarkdownReport, HostileTextBreaksNothing) {
  const std::string report =
      markdown_report({test::hostile_record(), test::passing_record()}, "# <b>title</b>");
  EXPECT_EQ(std::count(report.begin(), report.end(), '\0'), 0);
  EXPECT_EQ(std::count(report.begin(), report.end(), '\x1b'), 0);
  std::istringstream lines(report);
  std::string line;
  std::size_t table = 0;  // borders of the table that is being read; 0 outside
  while (std::getline(lines, line)) {
    if (line.starts_with("    ")) continue;  // code, in which nothing is live
    EXPECT_FALSE(has(line, "<")) << "no tag of a record is live";
    const std::size_t bars = borders(line);
    if (bars == 0) {
      table = 0;
      continue;
    }
    EXPECT_EQ(line.front(), '|') << line;
    if (table != 0) {
      EXPECT_EQ(bars, table) << line;
    }
    table = bars;
  }
}

TEST(MarkdownReport, NotANumberIsWritten) {
  const std::string report = markdown_report({test::hostile_record()});
  EXPECT_TRUE(has(report, "measured nan"));
  EXPECT_TRUE(has(report, "expected inf"));
}

TEST(MarkdownReport, NoRecords) {
  const std::string report = markdown_report({});
  EXPECT_TRUE(has(report, "of 0 records"));
  EXPECT_FALSE(has(report, "Overview"));
}

TEST(MarkdownReport, ARecordWithoutChecksKeepsItsReason) {
  const std::string report = markdown_report({test::not_applicable_record()});
  EXPECT_TRUE(has(report, "not applicable"));
  EXPECT_TRUE(has(report, "the engine has no deformable obstacles"));
}

TEST(MarkdownReport, TellsWhatFallsShortWithItsBandAndCause) {
  const std::string report =
      markdown_report({test::shortfall_record(), test::refuted_record()}, "Limits");
  EXPECT_TRUE(has(report, "0 fail, 1 expected shortfall, 1 refuted"));
  EXPECT_TRUE(has(report, "*expected shortfall*, as expected in \\[0.305, 0.32\\] m"));
  EXPECT_TRUE(has(report, "*refuted*, as expected in"));
  EXPECT_TRUE(has(report, "- Cause: normal forces never settle"));
  EXPECT_FALSE(has(report, "## What failed"));
}

TEST(MarkdownReport, TellsWhatLiesOutsideItsBand) {
  const std::string report = markdown_report({test::outside_record(0.2)}, "Limits");
  EXPECT_TRUE(has(report, "## What failed"));
  EXPECT_TRUE(has(report, "worse than expected \\[0.305, 0.32\\] m"));
  EXPECT_TRUE(has(report, "Cause of the band: normal forces never settle"));
}

}  // namespace
}  // namespace stiction
