// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/documents/figure_value.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reports/record/test_message.h"
#include "reports/record/test_records.h"

namespace stiction {
namespace {

using test::kInf;
using test::kNan;

Record record(const std::string& name, const std::string& method, double drift,
              Verdict verdict = Verdict::kPass) {
  Record one = test::passing_record(name);
  one.settings = {{"method", method}};
  one.checks[0].claim.quantity = "drift";
  one.checks[0].value = drift;
  one.checks[0].verdict = verdict;
  return one;
}

FigureRule drift_of(const std::string& case_glob) {
  FigureRule rule;
  rule.name = "drift";
  rule.where = "validate.toml:3";
  rule.case_glob = case_glob;
  rule.quantity = "drift";
  return rule;
}

TEST(FigureValue, IsThatOfTheRecordWithTheSettings) {
  FigureRule rule = drift_of("slab/rest");
  rule.settings = {{"method", "quiet"}};
  const FigureValue value = value_of(rule, {record("slab/rest", "paper", 3.0, Verdict::kShortfall),
                                            record("slab/rest", "quiet", 2.0)});
  EXPECT_EQ(value.low, 2.0);
  EXPECT_EQ(value.high, 2.0);
  EXPECT_EQ(value.verdict, Verdict::kPass);
}

TEST(FigureValue, AnEmptySettingIsOneThatIsNotSet) {
  FigureRule rule = drift_of("slab/rest");
  rule.settings = {{"sweeps", ""}};
  Record with = record("slab/rest", "quiet", 3.0);
  with.settings["sweeps"] = "4";
  EXPECT_EQ(value_of(rule, {with, record("slab/rest", "quiet", 2.0)}).low, 2.0);
}

TEST(FigureValue, TakesTheBestOfACaseAndTheRangeOverCases) {
  FigureRule rule = drift_of("rules/*");
  rule.except = "rules/membrane";
  rule.within = Taken::kLeast;
  rule.over = Taken::kRange;
  const FigureValue value =
      value_of(rule, {record("rules/a", "x", 5.0), record("rules/a", "y", 4.0),
                      record("rules/b", "x", 9.0, Verdict::kShortfall),
                      record("rules/b", "y", kInf), record("rules/membrane", "x", 100.0)});
  EXPECT_EQ(value.low, 4.0);
  EXPECT_EQ(value.high, 9.0);
  EXPECT_EQ(value.verdict, Verdict::kShortfall);
}

TEST(FigureValue, NoNumberAmongThemIsNone) {
  FigureRule rule = drift_of("*");
  rule.within = rule.over = Taken::kLeast;
  EXPECT_TRUE(std::isnan(value_of(rule, {record("a", "x", 1.0), record("b", "x", kNan)}).low));
}

TEST(FigureValue, IsThatOfASeriesNearASize) {
  FigureRule rule;
  rule.case_glob = "bench/slab/scaling";
  rule.series = "step per contact";
  rule.at = 1000.0;
  Record one = test::passing_record("bench/slab/scaling");
  one.series = {{"step per contact", "s", "contacts", "1", {100, 1089}, {5e-7, 4e-7}}};
  EXPECT_EQ(value_of(rule, {one}).low, 4e-7);
  rule.at = 10000.0;
  EXPECT_EQ(test::message_of([&] { value_of(rule, {one}); }),
            ": figure '': the record of 'bench/slab/scaling' has no series 'step per contact' at "
            "10000");
}

TEST(FigureValue, SaysWhatIsMissing) {
  FigureRule rule = drift_of("slab/rest");
  rule.settings = {{"method", "quiet"}};
  EXPECT_EQ(test::message_of([&] { value_of(rule, {record("slab/kappa", "quiet", 1.0)}); }),
            "validate.toml:3: figure 'drift': no record of a case 'slab/rest'");
  EXPECT_EQ(test::message_of([&] { value_of(rule, {record("slab/rest", "old", 1.0)}); }),
            "validate.toml:3: figure 'drift': no record of 'slab/rest' with method=quiet");
  Record renamed = record("slab/rest", "quiet", 1.0);
  renamed.checks[0].claim.quantity = "way";
  EXPECT_EQ(test::message_of([&] { value_of(rule, {renamed}); }),
            "validate.toml:3: figure 'drift': the record of 'slab/rest' has no quantity 'drift'");
  Record broken = test::error_record();
  broken.case_name = "slab/rest";
  broken.settings = {{"method", "quiet"}};
  EXPECT_EQ(
      test::message_of([&] { value_of(rule, {broken}); }),
      "validate.toml:3: figure 'drift': the record of 'slab/rest' is an error: " + broken.error);
}

TEST(FigureValue, OfWhatBrokeOrLacksWhatTheCaseNeedsIsAWord) {
  Record compared;
  compared.case_name = "engines/creep";
  FigureRule rule = drift_of("engines/creep");
  rule.quantity = "error";
  compared.verdict = Verdict::kNotApplicable;
  EXPECT_EQ(text_of(value_of(rule, {compared}), rule.style), "–");
  compared.verdict = Verdict::kForInformation;
  compared.failures = {{.reason = "it was ended by signal 9"}};
  EXPECT_EQ(text_of(value_of(rule, {compared}), rule.style), "broke");
  compared.failures.clear();
  EXPECT_THROW(value_of(rule, {compared}), std::runtime_error);
}

TEST(FigureValue, MayLeaveOutCasesThatLackIt) {
  FigureRule rule = drift_of("slab/*");
  rule.over = Taken::kMost;
  Record lacking = record("slab/a", "quiet", 3.0);
  lacking.checks.clear();
  EXPECT_THROW(value_of(rule, {lacking, record("slab/b", "quiet", 2.0)}), std::runtime_error);
  rule.may_lack = true;
  EXPECT_EQ(value_of(rule, {lacking, record("slab/b", "quiet", 2.0)}).low, 2.0);
  const FigureValue none = value_of(rule, {lacking});
  EXPECT_EQ(none.verdict, Verdict::kNotApplicable);
  EXPECT_EQ(text_of(none, {}), "–");
}

TEST(FigureValue, KnowsEngineAndConfigurationOfTheRecordItself) {
  FigureRule rule = drift_of("slab/rest");
  rule.settings = {{"engine", "ode"}, {"configuration", "best"}};
  Record ours = record("slab/rest", "quiet", 3.0), other = record("slab/rest", "quiet", 2.0);
  other.engine = "ode";
  other.configuration = "best";
  EXPECT_EQ(value_of(rule, {ours, other}).low, 2.0);
}

TEST(FigureText, IsInDecadesWhereDigitsAreCounted) {
  const FigureStyle style{.places = 1, .decades = true, .above = {{1.0, "none"}}};
  EXPECT_EQ(text_of({1e-12, 1e-12}, style), "12.0");
  EXPECT_EQ(text_of({0.0, 0.0}, style), "exact");
  EXPECT_EQ(text_of({kInf, kInf}, style), "none");
}

TEST(FigureValue, DoesNotChooseAmongSeveral) {
  const std::vector<Record> two = {record("slab/rest", "old", 1.0),
                                   record("slab/rest", "quiet", 2.0)};
  EXPECT_EQ(test::message_of([&] { value_of(drift_of("slab/rest"), two); }),
            "validate.toml:3: figure 'drift': 2 values in the case 'slab/rest', and the figure "
            "doesn't say which it takes");
}

TEST(FigureText, IsShortAndReadsWell) {
  const auto text = [](double value, FigureStyle style = {}) {
    return text_of({.low = value, .high = value}, style);
  };
  EXPECT_EQ(text(32.0), "32");
  EXPECT_EQ(text(0.0), "0");
  EXPECT_EQ(text(3.21e-4), "3e-4");
  EXPECT_EQ(text(0.00572, {.digits = 2}), "0.0057");
  EXPECT_EQ(text(1234.4, {.digits = 2}), "1234");
  EXPECT_EQ(text(2.5e7), "2e7");
  EXPECT_EQ(text(-0.0214, {.places = 3, .unit = "°"}), "−0.021°");
  EXPECT_EQ(text(1.4e-4, {.places = 2, .times = 100, .sign = true, .unit = " %"}), "+0.01 %");
  EXPECT_EQ(text(kInf), "never");
  EXPECT_EQ(text(kNan, {.no_number = "breaks"}), "breaks");
  EXPECT_EQ(text(0.03, {.above = {{0.01, "slips out"}, {1.0, "flies"}}}), "slips out");
  EXPECT_EQ(text(kInf, {.above = {{0.01, "slips out"}, {1.0, "flies"}}}), "flies");
  EXPECT_EQ(text_of({.low = 7, .high = 205}, {}), "7 to 205");
  EXPECT_EQ(text_of({.low = 1.1e-5, .high = 1.2e-5}, {}), "1e-5");
}

TEST(FigureBand, HoldsWithinAFactorOrBelowTheFloor) {
  FigureRule rule = drift_of("slab/rest");
  rule.floor = 1e-12;
  const auto differ = [&](double kept, double fresh, Verdict now = Verdict::kPass) {
    return disagreement(rule, {kept, kept, Verdict::kPass}, {fresh, fresh, now});
  };
  EXPECT_EQ(differ(1e-5, 9e-5), "");
  EXPECT_EQ(differ(1e-5, 1e-3),
            "'drift' is now 0.001, where the documents have 1e-05, which is beyond a factor of 10");
  EXPECT_EQ(differ(1e-17, 1e-13), "");
  EXPECT_NE(differ(1e-17, 1e-11), "");
  EXPECT_NE(differ(1e-5, -1e-5), "");
  EXPECT_NE(differ(kInf, 1.0), "");
  EXPECT_EQ(differ(kInf, kInf), "");
  EXPECT_EQ(differ(kNan, kNan), "");
  EXPECT_EQ(differ(1e-5, 1e-5, Verdict::kFail),
            "'drift' is now fail (1e-05), where the documents have pass (1e-05)");
}

TEST(Sample, IsTheSummaryOfTheLastRunThatHasItsCase) {
  const SampleRule rule{.name = "summary", .where = "validate.toml:9", .run_of = "slab/rest"};
  const std::vector<std::vector<Record>> runs = {
      {record("slab/rest", "old", 1.0)},
      {record("slab/rest", "old", 1.0), record("slab/rest", "quiet", 2.0)},
      {record("rules/slab", "quiet", 3.0)}};
  const std::string text = sample_of(rule, runs);
  EXPECT_NE(text.find("2 records, 1 case"), std::string::npos) << text;
  EXPECT_EQ(test::message_of([&] { sample_of(rule, {{record("a/case", "old", 1.0)}}); }),
            "validate.toml:9: sample 'summary': no run has a record of 'slab/rest'");
}

TEST(Sample, MayBeTheTableOfCheapestSettings) {
  Record run = record("work-precision/creep/cells=2/dt=1e-4", "quiet", 1.0);
  run.checks.clear();
  run.configuration = "quiet";
  run.figures = {{"error at most", "m/s", "", 2e-7},
                 {"of which uncertain", "m/s", "", 1e-13},
                 {"CPU time", "s/s", "", 0.05}};
  const SampleRule rule{.name = "cheapest",
                        .where = "work-precision.toml:9",
                        .run_of = run.case_name,
                        .shows = Shown::kCheapestSettings};
  const std::string text = sample_of(rule, {{run}});
  EXPECT_NE(text.find("| creep, m/s | 1e-3…1e-6 | quiet | 2 | 1e-4 | 0.05 | 2e-07 |  |\n"),
            std::string::npos)
      << text;
}

}  // namespace
}  // namespace stiction
