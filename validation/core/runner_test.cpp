// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/core/runner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <numeric>
#include <stdexcept>
#include <thread>

#include "solver/testing/test_refusal.h"
#include "validation/core/case_run.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Case named(const std::string& name, CaseSet set, std::vector<Settings> variants = {{}}) {
  return {.name = name, .title = "a test", .set = set, .variants = std::move(variants), .run = {}};
}

std::vector<Case> some_cases() {
  return {named("a/one", CaseSet::kQuick),
          named("a/two/mu=0.3", CaseSet::kDefault, {{{"rule", "none"}}, {{"rule", "fixed-point"}}}),
          named("b/three", CaseSet::kFull)};
}

std::vector<std::string> chosen(const Selection& selection) {
  std::vector<std::string> names;
  for (const Job& job : select_jobs(some_cases(), selection)) names.push_back(job.which.name);
  return names;
}

TEST(SelectJobs, TakesTheSetAskedForAndThoseWithinIt) {
  EXPECT_THAT(chosen({.set = CaseSet::kQuick}), ElementsAre("a/one"));
  EXPECT_THAT(chosen({.set = CaseSet::kDefault}),
              ElementsAre("a/one", "a/two/mu=0.3", "a/two/mu=0.3"));
  EXPECT_THAT(chosen({.set = CaseSet::kFull}),
              ElementsAre("a/one", "a/two/mu=0.3", "a/two/mu=0.3", "b/three"));
}

TEST(SelectJobs, TakesWhatAGlobNamesWhateverItsSet) {
  EXPECT_THAT(chosen({.globs = {"b/*"}, .set = CaseSet::kQuick}), ElementsAre("b/three"));
  EXPECT_THAT(chosen({.globs = {"*three", "a/on?"}}), ElementsAre("a/one", "b/three"));
  EXPECT_THAT(chosen({.globs = {"a/one", "a/*e"}}), ElementsAre("a/one")) << "once each";
  EXPECT_THAT(chosen({.globs = {"a*mu*"}}), ElementsAre("a/two/mu=0.3", "a/two/mu=0.3"))
      << "a star crosses '/'";
}

TEST(SelectJobs, RefusesAGlobThatMatchesNothing) {
  EXPECT_EQ(test::refusal([] {
              chosen({.globs = {"a/*", "c/*"}});
            }),
            "no case matches 'c/*'; --list shows them all");
}

TEST(SelectJobs, RefusesAnUnknownEngineAndNamesThoseThereAre) {
  const std::string sentence = test::refusal([] { chosen({.engine = "magic"}); });
  EXPECT_THAT(sentence, HasSubstr("unknown engine 'magic'"));
  EXPECT_THAT(sentence, HasSubstr("stiction"));
}

TEST(SelectJobs, PutsTheUsersSettingsOverThoseOfAVariantAndRunsEqualOnesOnce) {
  const std::vector<Job> jobs = select_jobs(
      some_cases(), {.globs = {"a/two*"}, .settings = {{"rule", "none"}, {"dt", "1e-4"}}});
  ASSERT_EQ(jobs.size(), 1u);
  EXPECT_EQ(jobs[0].settings, (Settings{{"rule", "none"}, {"dt", "1e-4"}}));
  EXPECT_EQ(select_jobs(some_cases(), {.globs = {"a/two*"}, .settings = {{"dt", "1e-4"}}}).size(),
            2u);
}

Job job_of(std::function<void(CaseRun&)> run) {
  Case one = named("test/job", CaseSet::kQuick);
  one.run = std::move(run);
  return {one, find_engine("stiction"), {}};
}

const Claim kNumber{.quantity = "number", .expected = 0.0, .tolerance = 1.0};

TEST(RunJob, MakesARecordOfWhatTheCaseFound) {
  const Record record = run_job(job_of([](CaseRun& run) {
                                  run.check(kNumber, 0.5);
                                  run.note("seen");
                                  run.add(Series{"series", "m", "time", "s", {0.0}, {1.0}});
                                }),
                                1.0);
  EXPECT_EQ(record.case_name, "test/job");
  EXPECT_EQ(record.title, "a test");
  EXPECT_EQ(record.engine, "stiction");
  EXPECT_EQ(record.verdict, Verdict::kPass);
  EXPECT_EQ(record.checks.size(), 1u);
  EXPECT_THAT(record.notes, ElementsAre("seen"));
  EXPECT_EQ(record.series.size(), 1u);
  EXPECT_EQ(record.state_hash, "") << "nothing was simulated";
  EXPECT_FALSE(record.environment.toolchain.empty());
}

TEST(RunJob, PassesTheToleranceScaleOn) {
  const Job job = job_of([](CaseRun& run) { run.check(kNumber, 0.5); });
  EXPECT_EQ(run_job(job, 0.0).verdict, Verdict::kFail);
  EXPECT_EQ(run_job(job, 0.6).verdict, Verdict::kPass);
}

TEST(RunJob, TurnsWhatGoesWrongIntoTheRecordsErrorAndKeepsTheChecksSoFar) {
  const Record record = run_job(job_of([](CaseRun& run) {
                                  run.check(kNumber, 0.5);
                                  throw std::runtime_error("it broke");
                                }),
                                1.0);
  EXPECT_EQ(record.verdict, Verdict::kError);
  EXPECT_EQ(record.error, "it broke");
  EXPECT_EQ(record.checks.size(), 1u);
}

TEST(RunJob, BillsEverySimulationAndRecordsTheResolvedSettings) {
  const Record record =
      run_job(job_of([](CaseRun& run) {
                InclineSetup setup;
                setup.shape = PointShape{};
                for (int k = 0; k < 2; ++k) {
                  run.simulate_with({{"dt", "1e-3"}}, incline_problem(setup))->advance_to(0.1);
                }
                run.check(kNumber, 0.0);
              }),
              1.0);
  EXPECT_EQ(record.cost.steps, 200u);
  EXPECT_EQ(record.cost.contact_updates, 200u);
  EXPECT_EQ(record.settings.at("dt"), "0.001");
  EXPECT_EQ(record.settings.at("rule"), "conjugate-vector");
  EXPECT_EQ(record.state_hash.size(), 16u);
}

// Boxes that slide and stop; different ones, so that a mix-up shows.
std::vector<Job> sliding_jobs() {
  std::vector<Job> jobs;
  for (int k = 0; k < 6; ++k) {
    jobs.push_back(job_of([k](CaseRun& run) {
      InclineSetup setup;
      setup.tan_slope = 0.1 * k;
      const auto simulation = run.simulate_with({{"cells", "1"}}, incline_problem(setup));
      simulation->advance_to(0.05);
      run.check(kNumber, simulation->engine().body(0).position.norm());
    }));
    jobs.back().which.name = "test/" + std::to_string(k);
  }
  return jobs;
}

std::vector<std::size_t> in_order(std::size_t jobs) {
  std::vector<std::size_t> order(jobs);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

std::vector<Record> run_all(const std::vector<Job>& jobs, int threads) {
  std::vector<Record> records(jobs.size());
  std::vector<int> calls(jobs.size(), 0);
  run_jobs(jobs, in_order(jobs.size()), threads, 1.0, [&](std::size_t index, Record record) {
    records[index] = std::move(record);
    ++calls[index];
  });
  EXPECT_EQ(calls, std::vector<int>(jobs.size(), 1));
  return records;
}

TEST(RunJobs, GivesTheSameRecordsOnOneThreadAndOnTwo) {
  const std::vector<Job> jobs = sliding_jobs();
  const std::vector<Record> one = run_all(jobs, 1);
  const std::vector<Record> two = run_all(jobs, 2);
  for (std::size_t k = 0; k < jobs.size(); ++k) {
    EXPECT_EQ(one[k].case_name, jobs[k].which.name);
    EXPECT_EQ(two[k].case_name, jobs[k].which.name);
    EXPECT_EQ(one[k].state_hash, two[k].state_hash);
    EXPECT_EQ(one[k].state_hash.size(), 16u);
    EXPECT_EQ(one[k].checks[0].value, two[k].checks[0].value);
    EXPECT_EQ(one[k].cost.contact_updates, two[k].cost.contact_updates);
    if (k > 0) {
      EXPECT_NE(one[k].state_hash, one[k - 1].state_hash);
    }
  }
}

TEST(RunJobs, BeginsThemInTheOrderThatIsSaid) {
  const std::size_t order[] = {4, 0, 5, 1, 2, 3};
  std::vector<std::size_t> finished;
  run_jobs(sliding_jobs(), order, 1, 1.0,
           [&](std::size_t index, const Record&) { finished.push_back(index); });
  EXPECT_EQ(finished, std::vector<std::size_t>(std::begin(order), std::end(order)));
}

TEST(RunJobs, StopsWhenARecordCannotBeKeptAndPassesTheReasonOn) {
  for (const int threads : {1, 2}) {
    std::atomic<int> started{0};
    const std::vector<Job> jobs(50, job_of([&](CaseRun& run) {
                                  ++started;
                                  // Both threads are at work when the first record fails.
                                  for (int ms = 0; started < threads && ms < 1000; ++ms) {
                                    std::this_thread::sleep_for(std::chrono::milliseconds(1));
                                  }
                                  run.check(kNumber, 0.0);
                                }));
    int records = 0;
    const auto keep = [&](std::size_t, const Record&) {
      if (records++ == 0) throw std::runtime_error("disk full");
    };
    EXPECT_THROW(run_jobs(jobs, in_order(jobs.size()), threads, 1.0, keep), std::runtime_error);
    EXPECT_LE(started.load(), threads) << "no further job starts";
  }
}

}  // namespace
}  // namespace stiction
