// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/bench/bench_summary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "reports/text/text.h"

namespace stiction::bench {
namespace {

using testing::HasSubstr;
using testing::Not;

Result result(const std::string& part, int size, double nanoseconds) {
  Result one;
  one.chosen.timed.name = part;
  one.chosen.family.name = "slab";
  one.chosen.size = size;
  one.chosen.name = part + "/slab/contacts:" + std::to_string(size);
  one.contacts = size;
  one.seconds = 1e-9 * nanoseconds * size;
  one.error = 0.02;
  return one;
}

std::vector<Result> three_sizes() {
  std::vector<Result> results;
  for (const int size : {100, 1000, 10000}) {
    results.push_back(result("detect", size, 40));
    results.push_back(result("depth", size, 60));
    results.push_back(result("friction:secant", size, 35));
    results.push_back(result("friction:none", size, 20));
    results.push_back(result("step", size, 500));
  }
  return results;
}

TEST(BenchSummary, TellsWhatAContactCostsAndHowThatGrows) {
  const std::vector<Result> results = three_sizes();
  const std::string text = bench_summary(results, scalings(results), {}, {}, Screen{});
  EXPECT_THAT(text, testing::ContainsRegex("detection and depth +100 +100 +100 +1.00 ± 0.00"));
  EXPECT_THAT(text, testing::ContainsRegex("whole step +500 +500 +500 +1.00 ± 0.00"));
  EXPECT_THAT(text, HasSubstr("10 000"));
  EXPECT_THAT(text, HasSubstr("Friction, slab, 1 000 contacts"));
  EXPECT_THAT(text, HasSubstr("secant 35 (0.02).\n"));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(display_width(line), 80u) << line;
}

TEST(BenchSummary, TellsHowMuchFasterThreadsDoAWholeStep) {
  std::vector<Result> results = three_sizes();
  EXPECT_THAT(bench_summary(results, {}, {}, {}, Screen{}), Not(HasSubstr("threads")));
  for (Result& one : results) {
    one.chosen.timed.whole_step = one.chosen.timed.name == "step";
    const double ratio = one.chosen.timed.whole_step ? 1.9 : 1.2;
    if (one.chosen.size > 100)
      one.speed_up =
          SpeedUp{4, {ratio - 0.1, ratio, ratio + 0.1}, true, {{55e-9, 1.9}, {480e-9, 1.2}}};
    if (one.chosen.size > 1000) one.speed_up->together[1] = {58e-9, 1.95};
  }
  EXPECT_THAT(bench_summary(results, {}, {}, {}, Screen{}),
              testing::ContainsRegex("slab +… 4 threads, × faster +– +1.90 +1.90"));
  EXPECT_THAT(bench_summary(results, {}, {}, {}, Screen{}),
              testing::ContainsRegex("ns for an answer, core to core +– +55–480 +55"));
  EXPECT_THAT(bench_summary(results, {}, {}, {}, Screen{}),
              testing::ContainsRegex("× faster, arithmetic +– +1.20–1.90 +1.90"));
}

TEST(BenchSummary, OfPartsAloneEachIsTold) {
  const std::vector<Result> results = {result("friction:secant", 100, 35)};
  const std::string text = bench_summary(results, {}, {}, {}, Screen{});
  EXPECT_THAT(text, HasSubstr("friction:secant/slab/contacts:100"));
  EXPECT_THAT(text, Not(HasSubstr("whole step")));
}

TEST(BenchSummary, TellsWhatWasNotAtRestAndHowToMeasureItAgain) {
  Record record;
  record.case_name = "bench/slab/contacts=100";
  record.verdict = Verdict::kFail;
  record.checks.push_back({.claim = {.quantity = "mean slip", .expected = 0.0, .tolerance = 0.05},
                           .value = 0.2,
                           .verdict = Verdict::kFail});
  const std::string text = bench_summary(three_sizes(), {}, {}, {record}, Screen{});
  EXPECT_THAT(text, HasSubstr("FAIL bench/slab/contacts=100: mean slip is 0.2, not 0 ± 0.05"));
  EXPECT_THAT(text, HasSubstr("again: ./stiction bench --benchmark_filter='/slab/'"));
  EXPECT_THAT(text, HasSubstr("0 of 1 workloads at rest"));
}

TEST(BenchSummary, NamesTheDearestOfTheFeaturesThatAreNotUsed) {
  const std::vector<FeatureCost> features = {{"a", "one", 1000, 993, 1010},
                                             {"b", "another", 1000, 1004, 1036}};
  EXPECT_THAT(bench_summary(three_sizes(), {}, features, {}, {.width = 200}),
              HasSubstr("2 optional features, unused: -0.7 to +0.4 % of a step's instructions "
                        "(dearest: another)."));
}

}  // namespace
}  // namespace stiction::bench
