// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/decide/accuracy.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stiction::track {
namespace {

Record record_of(const std::string& rule, std::vector<Judgement> checks) {
  Record record;
  record.case_name = "slab/creep";
  record.settings = {{"dt", "0.001"}, {"rule", rule}};
  record.checks = std::move(checks);
  record.cost.steps = 1000;
  record.cost.contact_updates = 77;
  record.verdict = combined_verdict(record.checks);
  record.state_hash = "0123456789abcdef";
  record.environment.machine = "Example, CPU, 2 cores";
  record.environment.toolchain = "GCC 12.2.0, Release -O3";
  return record;
}

Judgement check_of(const std::string& quantity, double digits, Verdict verdict,
                   double value = 0.0) {
  Judgement check;
  check.claim.quantity = quantity;
  check.digits = digits;
  check.verdict = verdict;
  check.value = value;
  return check;
}

TEST(CaseAccuracy, NamesWhatDiffersBetweenTheRecordsOfACase) {
  const CaseAccuracy both = accuracy_of({record_of("none", {}), record_of("secant", {})});
  EXPECT_EQ(both.state_hash.count("slab/creep@rule=none"), 1u);
  EXPECT_EQ(both.state_hash.count("slab/creep@rule=secant"), 1u);
  EXPECT_EQ(accuracy_of({record_of("none", {})}).state_hash.count("slab/creep"), 1u);
}

TEST(CaseAccuracy, NamesNoMoreSettingsThanNeeded) {
  // method tells two apart, rule three; with rule nothing is left to tell but the last two.
  Record a = record_of("none", {}), b = record_of("secant", {}), c = record_of("vector", {}), d = c;
  a.settings["method"] = "old";
  d.settings["kappa"] = "0.5";
  d.settings["tie"] = "1";
  const CaseAccuracy all = accuracy_of({a, b, c, d});
  EXPECT_EQ(all.state_hash.size(), 4u);
  EXPECT_EQ(all.state_hash.count("slab/creep@rule=none"), 1u);
  EXPECT_EQ(all.state_hash.count("slab/creep@kappa=0.5,rule=vector"), 1u);
  EXPECT_EQ(all.state_hash.count("slab/creep@rule=vector"), 1u);
}

TEST(CaseAccuracy, TakesDigitsOfChecksThatMustHold) {
  const CaseAccuracy all = accuracy_of({record_of(
      "none", {check_of("a", 5, Verdict::kPass), check_of("b", 4, Verdict::kFail),
               check_of("c", 3, Verdict::kShortfall), check_of("d", 2, Verdict::kForInformation),
               check_of("e", 2, Verdict::kRefuted)})});
  const Measurements& found = all.measurements;
  ASSERT_NE(found.find("slab/creep#digits: a"), nullptr);
  EXPECT_EQ(found.find("slab/creep#digits: a")->samples, std::vector<double>{5.0});
  EXPECT_EQ(found.find("slab/creep#digits: b")->samples, std::vector<double>{4.0});
  EXPECT_EQ(found.find("slab/creep#digits: c"), nullptr);
  EXPECT_EQ(found.find("slab/creep#verdict: b")->samples, std::vector<double>{2.0});
  EXPECT_EQ(found.find("slab/creep#verdict: c")->samples, std::vector<double>{1.0});
  EXPECT_EQ(found.find("slab/creep#digits: e"), nullptr);
  EXPECT_EQ(found.find("slab/creep#verdict: e")->samples, std::vector<double>{1.0});
  EXPECT_EQ(found.find("slab/creep#verdict: d"), nullptr);
  EXPECT_EQ(found.find("slab/creep#verdict")->samples, std::vector<double>{2.0});
  EXPECT_EQ(found.find("slab/creep#contact updates")->samples, std::vector<double>{77.0});
}

TEST(CaseAccuracy, ClipsDigitsAtTheRoundOffOfItsSteps) {
  const CaseAccuracy all = accuracy_of(
      {record_of("none", {check_of("a", 16, Verdict::kPass), check_of("b", 12, Verdict::kPass),
                          check_of("c", std::nan(""), Verdict::kFail)})});
  // 1000 steps of 2.2e-16.
  EXPECT_NEAR(all.measurements.find("slab/creep#digits: a")->samples[0], 12.65, 0.01);
  EXPECT_EQ(all.measurements.find("slab/creep#digits: b")->samples[0], 12.0);
  EXPECT_EQ(all.measurements.find("slab/creep#digits: c")->samples[0], 0.0);
}

TEST(CaseAccuracy, CountsStepsToConvergence) {
  const CaseAccuracy all = accuracy_of({record_of(
      "none", {check_of("steps until the mean slip stays below", 2, Verdict::kPass, 140.0)})});
  const Measurement* const steps =
      all.measurements.find("slab/creep#steps until the mean slip stays below");
  ASSERT_NE(steps, nullptr);
  EXPECT_EQ(steps->samples, std::vector<double>{140.0});
  EXPECT_FALSE(higher_is_better(steps->metric.kind));
}

TEST(CaseAccuracy, ReadsTheMachine) {
  const Machine machine = accuracy_of({record_of("none", {})}).machine;
  EXPECT_EQ(machine, (Machine{"Example, CPU", 2, "GCC 12.2.0", "Release -O3"}));
}

}  // namespace
}  // namespace stiction::track
