// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/measure/google_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "benchmarks/track/measure/child.h"

namespace stiction::track {
namespace {

// As Google Benchmark 1.7 writes it, with an aggregate.
constexpr const char* kText = R"({"context": {"date": "2026-01-01", "host_name": "here",
 "num_cpus": 2, "library_build_type": "release"}, "benchmarks": [
 {"name": "a/1", "run_name": "a/1", "run_type": "iteration", "repetition_index": 0,
  "cpu_time": 2.5, "time_unit": "us"},
 {"name": "a/1", "run_name": "a/1", "run_type": "iteration", "repetition_index": 1,
  "cpu_time": 3.5, "time_unit": "us"},
 {"name": "b/1", "run_name": "b/1", "run_type": "iteration", "repetition_index": 0,
  "cpu_time": 1, "time_unit": "ms", "time_per_contact": 5e-8},
 {"name": "a/1_mean", "run_name": "a/1", "run_type": "aggregate", "cpu_time": 3}]})";

TEST(GoogleJson, GivesRepetitionsInSeconds) {
  const std::vector<GoogleResult> results = read_google_results(kText, "file");
  ASSERT_EQ(results.size(), 3u);
  EXPECT_EQ(results[1].name, "a/1");
  EXPECT_DOUBLE_EQ(results[1].seconds, 3.5e-6);
  EXPECT_DOUBLE_EQ(results[2].seconds, 5e-8);  // per contact
}

TEST(GoogleJson, BecomesARun) {
  const StoredRun run = run_from_google_json(kText, "file");
  EXPECT_EQ(run.date, "2026-01-01");
  EXPECT_EQ(run.label, "file");
  EXPECT_EQ(run.machine, (Machine{"here", 2, "unknown", "release"}));
  EXPECT_EQ(run.measurements.find("a/1#time")->samples.size(), 2u);
}

TEST(GoogleJson, ComesBackFromAnExport) {
  StoredRun run{.date = "2026-01-01",
                .revision = "0123456789ab",
                .machine = {"Example CPU", 2, "GCC 12", "-O3"}};
  for (const double time : {1e-8 / 3.0, 2e-8}) {
    run.measurements.add({"a/1", "time", "s", Kind::kTime}, time);
  }
  run.measurements.add({"a/1", "instructions", "1", Kind::kCount}, 1234567.0);
  run.measurements.add({"a/1", "digits: error", "1", Kind::kDigits}, 5.25);
  const StoredRun again = run_from_google_json(to_google_json(run), "file");
  EXPECT_EQ(again.machine, run.machine);
  EXPECT_EQ(again.revision, run.revision);
  ASSERT_EQ(again.measurements.all().size(), 3u);
  for (const auto& [name, measurement] : run.measurements.all()) {
    const Measurement* const found = again.measurements.find(name);
    ASSERT_NE(found, nullptr) << name;
    EXPECT_EQ(found->metric.kind, measurement.metric.kind);
    ASSERT_EQ(found->samples.size(), measurement.samples.size());
    for (std::size_t k = 0; k < found->samples.size(); ++k) {
      EXPECT_DOUBLE_EQ(found->samples[k], measurement.samples[k]);
    }
  }
  // Other readers find the counters where Google Benchmark puts them.
  EXPECT_EQ(nlohmann::json::parse(to_google_json(run))["benchmarks"][0]["instructions"], 1234567.0);
}

TEST(GoogleJson, RefusesOtherText) {
  for (const char* text :
       {"", "[]", "{}", R"({"benchmarks": 1})", R"({"benchmarks": []})",
        R"({"benchmarks": [{"name": "a"}]})",
        R"({"benchmarks": [{"name": "a", "cpu_time": 1, "time_unit": "fortnights"}]})",
        R"({"benchmarks": [{"name": "a", "error_occurred": true, "error_message": "no"}]})"}) {
    EXPECT_THROW(run_from_google_json(text, "file"), TrackError) << text;
  }
}

}  // namespace
}  // namespace stiction::track
