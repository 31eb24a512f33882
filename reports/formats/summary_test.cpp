// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/summary.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/formats/failure_block.h"
#include "reports/formats/test_screen.h"
#include "reports/record/test_records.h"
#include "reports/text/text.h"

namespace stiction {
namespace {

using test::kWide;
using test::lines_of;
using testing::HasSubstr;
using testing::Not;

// A run as large as the default one: two methods, and shortfalls of twelve causes.
std::vector<Record> large_run() {
  std::vector<Record> records;
  for (int k = 0; k < 12; ++k) {
    Record quiet = test::passing_record(fmt::format("stack/case-with-a-long-name/n={}", k));
    quiet.configuration = "quiet";
    quiet.differs.clear();
    quiet.checks[0].claim.headline = fmt::format("a headline of number {} that says much", k % 9);
    records.push_back(quiet);
    Record paper = test::refuted_record();
    paper.case_name = quiet.case_name;
    paper.differs.clear();
    for (Judgement& check : paper.checks) {
      check.because = fmt::format("cause {} that contacts come and go", k);
    }
    records.push_back(paper);
  }
  return records;
}

TEST(Summary, SaysWhoHoldsHowAccuratelyAndWhy) {
  const std::string text = summary_screen(large_run(), kWide, 139.4);
  EXPECT_THAT(text, HasSubstr("stiction 4f2a9c1+ · 24 records, 12 cases · 2 min 19 s (6 s CPU)"));
  EXPECT_THAT(text,
              HasSubstr("0 fail, 0 broke off · 12 hold · 12 fall short as expected (12 refute "
                        "the paper)"));
  EXPECT_THAT(text, HasSubstr("Who holds (hold, CPU: the 12 cases that all ran)"));
  EXPECT_THAT(text, HasSubstr("quiet               12/12"));
  EXPECT_THAT(text, HasSubstr("paper, fixed point   0/12"));
  EXPECT_THAT(text, HasSubstr("How accurate (quiet)"));
  EXPECT_THAT(text, HasSubstr("4e-05 rel  0.0001 rel   40 %"));
  EXPECT_THAT(text, HasSubstr("nearest to failing: 40 % of the tolerance, "
                              "stack/case-with-a-long-name/n=0: critical slope"));
  EXPECT_THAT(text, HasSubstr("Why 12 fall short as expected"));
  EXPECT_THAT(text, HasSubstr("cause 11 that contacts come and go"));
}

TEST(Summary, FitsItsScreen) {
  for (const std::size_t width : {80u, 100u, 200u}) {
    for (const std::size_t height : {24u, 40u}) {
      const auto lines = lines_of(summary_screen(large_run(), {.width = width, .height = height}));
      EXPECT_LE(lines.size() + 3, height)
          << "two lines that tell where reports are, and the prompt";
      for (const std::string& line : lines) EXPECT_LE(display_width(line), width) << line;
    }
  }
  EXPECT_THAT(summary_screen(large_run(), {.width = 80, .height = 24}),
              HasSubstr("more causes, in report.md"));
}

TEST(Summary, NamesWhatFails) {
  std::vector<Record> records = large_run();
  EXPECT_EQ(failure_block(records.front(), kWide), "");
  records.push_back(test::failing_record());
  records.push_back(test::error_record());
  records.push_back(test::outside_record(7.0));
  const std::string text = summary_screen(records, {.width = 200});
  EXPECT_THAT(text, HasSubstr("2 fail, 1 broke off · 12 hold"));
  EXPECT_THAT(text,
              HasSubstr("FAIL     incline/below/mu=0.3 paper, fixed point, kappa=0.7: stopping "
                        "distance: 100 × its tolerance"));
  EXPECT_THAT(text, HasSubstr("ERROR    incline/above/mu=0.9"));
  EXPECT_THAT(text, HasSubstr("worse than expected [0.305, 0.32] m"));
}

TEST(Summary, TellsOfFailuresThatNoNumberMeasures) {
  const auto told = [](double value, double of_tolerance) {
    Record record = test::failing_record();
    for (Judgement& check : record.checks) {
      check.value = value;
      check.of_tolerance = of_tolerance;
    }
    return summary_screen({record}, {.width = 200});
  };
  EXPECT_THAT(told(test::kNan, test::kInf), HasSubstr("stopping distance: no number"));
  EXPECT_THAT(told(1.0, test::kInf),
              HasSubstr("stopping distance: endlessly beyond its tolerance"));
}

TEST(Summary, OfManyFailuresNamesTheFirst) {
  const std::vector<Record> records(30, test::failing_record());
  const auto lines = lines_of(summary_screen(records, {.width = 80, .height = 24}));
  EXPECT_LE(lines.size(), 40u);
  EXPECT_THAT(summary_screen(records, {.width = 80}),
              HasSubstr("and 22 more, each whole in report.md"));
}

TEST(Summary, SaysWhatIsLacking) {
  EXPECT_THAT(summary_screen({test::not_applicable_record(), test::passing_record()}, kWide),
              HasSubstr("n/a      the engine has no deformable obstacles: slab/threshold"));
}

TEST(Summary, ColourAddsOnlyColour) {
  EXPECT_THAT(summary_screen({test::failing_record()}, kWide), Not(HasSubstr("\x1b")));
  EXPECT_THAT(summary_screen({test::failing_record()}, {.width = 100, .colour = true}),
              HasSubstr("\x1b["));
}

TEST(Summary, OfNothingAndOfHostileText) {
  EXPECT_EQ(summary_screen({}, kWide), "no records\n");
  const Record hostile = test::hostile_record();
  for (const std::string& text :
       {summary_screen({hostile}, kWide), failure_block(hostile, kWide)}) {
    EXPECT_THAT(text, Not(HasSubstr("\x1b")));
    EXPECT_EQ(text.find_first_of(std::string_view("\0\r\t", 3)), std::string::npos);
  }
}

TEST(FailureBlock, TellsAllAndHowToRunItAgain) {
  const std::string text = failure_block(test::failing_record(), {.width = 200});
  EXPECT_THAT(text, HasSubstr("stopping distance: measured 0.31 m, expected 0.3 m (analytic)"));
  EXPECT_THAT(text, HasSubstr("worst at: vertex 17 at t = 0.42 s"));
  EXPECT_THAT(text, HasSubstr("why this tolerance: v₀Δt/2, the bias of symplectic Euler"));
  EXPECT_THAT(text, HasSubstr("note: Fails until the stop is resolved within a step."));
  EXPECT_THAT(text, HasSubstr("again: ./stiction validate --case 'incline/below/mu=0.3' "
                              "--configuration 'paper, fixed point' --set 'kappa=0.7'"));
  EXPECT_THAT(failure_block(test::outside_record(7.0), {.width = 200}),
              HasSubstr("cause of the band: normal forces never settle"));
  EXPECT_THAT(failure_block(test::error_record(), {.width = 200}),
              HasSubstr("the time step 0.1 s is above the stability limit of element 3"));
}

}  // namespace
}  // namespace stiction
