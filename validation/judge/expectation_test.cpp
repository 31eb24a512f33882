// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/judge/expectation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "reports/text/check_text.h"
#include "validation/core/case_run.h"
#include "validation/core/runner.h"
#include "validation/judge/test_cause.h"

namespace stiction {
namespace {

using test::kCause;
using test::kWidth;
using testing::HasSubstr;

Expectations some_rows() {
  return {
      {"a/*", "method=paper", "slip", {1e-6, 9e-6}, Verdict::kShortfall, kCause, kWidth},
      {"a/one", "method=paper", "drift", {1e-3, 2e-3}, Verdict::kRefuted, kCause, kWidth},
      {"a/one", "method=old", "drift", {1.0, INFINITY}, Verdict::kShortfall, kCause, kWidth},
  };
}

TEST(Expectations, AreThoseOfCaseAndVariant) {
  EXPECT_EQ(expectations_of(some_rows(), "a/one", "method=paper").size(), 2u);
  EXPECT_EQ(expectations_of(some_rows(), "a/two/mu=0.3", "method=paper").size(), 1u)
      << "a star crosses '/'";
  EXPECT_EQ(expectations_of(some_rows(), "a/one", "method=old").size(), 1u);
  EXPECT_TRUE(expectations_of(some_rows(), "a/one", "method=paper rule=secant").empty());
  EXPECT_TRUE(expectations_of(some_rows(), "b/one", "method=paper").empty());
  EXPECT_TRUE(expectations_of(some_rows(), "a/one", "").empty());
}

TEST(Expectations, OfAQuantity) {
  const Expectations rows = expectations_of(some_rows(), "a/one", "method=paper");
  ASSERT_NE(find_expectation(rows, "drift"), nullptr);
  EXPECT_EQ(find_expectation(rows, "drift")->band.high, 2e-3);
  EXPECT_EQ(find_expectation(rows, "energy"), nullptr);
  EXPECT_EQ(find_expectation(rows, "drif"), nullptr);
}

TEST(Expectations, TwoRowsForOneCheckAreAFault) {
  Expectations rows = some_rows();
  rows.push_back(rows.front());
  EXPECT_THROW(find_expectation(rows, "slip"), std::logic_error);
}

TEST(Variant, IsSpelledAsInTables) {
  EXPECT_EQ(variant_text({}), "default");
  EXPECT_EQ(variant_text({{"rule", "secant"}, {"method", "paper"}}), "method=paper rule=secant");
}

// A job of case a/one whose checks measure `drift` and `slip`; other expectations as some_rows().
struct Measured {
  double slip = 3e-6;
  double drift = 1.5e-3;
};

Job job_of(const Measured& measured, Settings settings = {{"method", "paper"}}) {
  Case one{.name = "a/one",
           .title = "a test",
           .variants = {{{"method", "old"}}, {{"method", "paper"}}},
           .run = [measured](CaseRun& run) {
             run.check({.quantity = "slip", .tolerance = 1e-9}, measured.slip);
             if (!std::isnan(measured.drift)) {
               run.check({.quantity = "drift", .tolerance = 1e-9}, measured.drift);
             }
           }};
  EngineKind engine = find_engine("stiction");
  engine.expectations = some_rows();
  return {one, engine, std::move(settings)};
}

TEST(RunJob, JudgesByTheEnginesTable) {
  const Record record = run_job(job_of({}), 1.0);
  EXPECT_EQ(record.variant, "method=paper");
  EXPECT_EQ(record.checks[0].verdict, Verdict::kShortfall);
  EXPECT_EQ(record.checks[1].verdict, Verdict::kRefuted);
  EXPECT_EQ(record.verdict, Verdict::kShortfall);
  EXPECT_EQ(record.checks[1].cause, "a cause (band: a width)");
  EXPECT_EQ(record.checks[1].because, "in short");
}

TEST(RunJob, FailsAMillionTimesWorseThanKnown) {
  const Record record = run_job(job_of({.slip = 3.0}), 1.0);
  EXPECT_EQ(record.verdict, Verdict::kFail);
  EXPECT_THAT(check_sentence(record.checks[0]), HasSubstr("worse than expected [1e-06, 9e-06]"));
}

TEST(RunJob, FailsBetterThanKnown) {
  for (const double slip : {1e-8, 0.0}) {
    const Record record = run_job(job_of({.slip = slip}), 1.0);
    EXPECT_EQ(record.verdict, Verdict::kFail);
    EXPECT_THAT(check_sentence(record.checks[0]), HasSubstr("better than known [1e-06, 9e-06]"));
    EXPECT_THAT(check_sentence(record.checks[0]), HasSubstr("raise the bar"));
  }
}

TEST(RunJob, FailsAnExpectationThatMeetsNoCheck) {
  const Record record = run_job(job_of({.drift = NAN}), 1.0);
  EXPECT_EQ(record.verdict, Verdict::kFail);
  EXPECT_EQ(record.checks.back().claim.quantity, "checks of 'drift'");
  EXPECT_EQ(record.checks.back().verdict, Verdict::kFail);
}

TEST(RunJob, JudgesOfTheOldMethodOnlyWhatIsExpectedOfIt) {
  const Record record = run_job(job_of({.drift = 5.0}, {{"method", "old"}}), 1.0);
  EXPECT_EQ(record.checks[0].verdict, Verdict::kForInformation);
  EXPECT_EQ(record.checks[1].verdict, Verdict::kShortfall) << "it breaks, as it must";
  EXPECT_EQ(run_job(job_of({.drift = 0.0}, {{"method", "old"}}), 1.0).verdict, Verdict::kFail)
      << "it doesn't break, where it must";
}

TEST(RunJob, ExpectsNothingOfSettingsOrATolerancThatAreTheUsersOwn) {
  const Record record = run_job(job_of({}, {{"method", "paper"}, {"dt", "1e-4"}}), 1.0);
  EXPECT_EQ(record.variant, "");
  for (const Judgement& check : record.checks) {
    EXPECT_EQ(check.verdict, Verdict::kFail);
    EXPECT_FALSE(check.band.has_value());
  }
  EXPECT_EQ(run_job(job_of({}), 1e9).verdict, Verdict::kPass);
  EXPECT_EQ(run_job(job_of({}), 0.5).verdict, Verdict::kFail);
  EXPECT_EQ(run_job(job_of({.drift = NAN}), 1e9).checks.size(), 1u) << "nor a row that is unmet";
}

TEST(RunJob, AtFinerStepsJudgesWhatHoldsAndTellsTheRest) {
  Job job = job_of({});
  job.finer = 2;
  Problem still;
  ProblemBody& point = still.bodies.emplace_back();
  point.shape = PointShape{};
  point.mass = 1.0;
  double time_step = 0.0;
  job.which.run = [&, measure = job.which.run](CaseRun& run) {
    measure(run);
    run.check({.quantity = "energy", .tolerance = 1e-9}, 1.0);
    CaseRun part = run.part(run.settings());
    time_step = part.simulate(still, {.time = 1e-3, .finer = 2.0})->engine().time_step();
  };
  const Record record = run_job(job, 1.0);
  EXPECT_EQ(time_step, 2.5e-4);
  ASSERT_EQ(record.checks.size(), 3u);
  EXPECT_EQ(record.checks[0].verdict, Verdict::kForInformation)
      << "it falls short at the usual step";
  EXPECT_EQ(record.checks[1].verdict, Verdict::kForInformation);
  EXPECT_EQ(record.checks[2].verdict, Verdict::kFail);
  EXPECT_EQ(record.verdict, Verdict::kFail);
  EXPECT_THAT(record.notes,
              testing::ElementsAre(HasSubstr("time steps are 1/2 of the usual ones")));
}

}  // namespace
}  // namespace stiction
