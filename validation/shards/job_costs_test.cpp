// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/shards/job_costs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "validation/engine/engine.h"

namespace stiction {
namespace {

std::vector<Job> jobs_of_cases(const std::vector<std::string>& names) {
  const EngineKind engine = find_engine("stiction");
  std::vector<Job> jobs;
  for (const std::string& name : names) {
    Job job;
    job.which.name = name;
    job.engine = engine;
    jobs.push_back(job);
  }
  return jobs;
}

TEST(JobCosts, AreThoseOfTheTableOfTheFamilyOrTheMedian) {
  const std::span<const CaseCost> table = case_costs();
  // As jobs without settings are called.
  const CaseCost known = *std::find_if(table.begin(), table.end(), [](const CaseCost& row) {
    return std::string(row.configuration) == "quiet" && row.cpu_seconds > 1.0;
  });
  const std::vector<double> seconds =
      estimated_seconds(jobs_of_cases({known.case_name, "no/such-family"}));
  ASSERT_EQ(seconds.size(), 2u);
  EXPECT_NEAR(seconds[0], known.cpu_seconds, 0.05) << "what starting a case takes comes on top";
  EXPECT_GT(seconds[1], 0.0);
}

TEST(JobCosts, OfAnotherCaseOfAFamilyAreItsMean) {
  const std::string name = case_costs().front().case_name;
  const std::string other = name.substr(0, name.find_last_of('/')) + "/never-measured";
  const std::vector<double> seconds = estimated_seconds(jobs_of_cases({other, "no/such-family"}));
  EXPECT_NE(seconds[0], seconds[1]);
}

TEST(JobCosts, TheTableNamesEachCaseAndConfigurationOnce) {
  std::set<std::string> seen;
  for (const CaseCost& row : case_costs()) {
    EXPECT_TRUE(seen.insert(std::string(row.case_name) + "\n" + row.configuration).second)
        << row.case_name << ", " << row.configuration;
    EXPECT_GE(row.cpu_seconds, 0.0);
  }
  EXPECT_GT(seen.size(), 200u) << "case_costs.py writes it from the records of ./stiction validate";
}

TEST(OrderToBegin, TakesALongJobBeforeItWouldBeTheLastAlone) {
  using Order = std::vector<std::size_t>;
  EXPECT_EQ(order_to_begin({}, 2), Order{});
  EXPECT_EQ(order_to_begin({1, 1, 1, 1}, 2), (Order{0, 1, 2, 3}));
  EXPECT_EQ(order_to_begin({1, 1, 1, 1, 1, 1, 1, 1, 4}, 2), (Order{0, 1, 2, 3, 8, 4, 5, 6, 7}));
  EXPECT_EQ(order_to_begin({1, 1, 1, 1, 1, 1, 1, 1, 4}, 1), (Order{0, 1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(order_to_begin({1, 1, 9}, 2), (Order{2, 0, 1})) << "longer than all others";
  EXPECT_EQ(order_to_begin({1, 1, 1, 1, 1, 3, 2}, 3), (Order{0, 5, 6, 1, 2, 3, 4}));
}

TEST(JobCosts, JobsOfACaseStayTogetherWhereTheyMayShare) {
  const std::vector<Job> jobs = jobs_of_cases({"a/x", "b/y", "a/x", "c/z", "b/y", "a/x"});
  for (std::size_t number = 1; number <= 3; ++number) {
    std::set<std::string> names;
    std::size_t of_names = 0;
    const std::vector<std::size_t> own = jobs_of({number, 3}, jobs, Together::kCases);
    for (const std::size_t k : own) names.insert(jobs[k].which.name);
    for (const Job& job : jobs) of_names += names.count(job.which.name);
    EXPECT_EQ(own.size(), of_names) << "shard " << number;
  }
}

}  // namespace
}  // namespace stiction
