// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/measure/google_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "benchmarks/track/measure/child.h"
#include "benchmarks/track/store/scratch.h"

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

// A run with all that may be in one.
StoredRun full_run() {
  const std::string hostile = "a/\"1\"\\,\n\t\x01</script>|`;µ→\xF0\x9F\x98\x80";
  StoredRun run{.date = "2026-01-01T00:00:00Z",
                .revision = "0123456789ab+",
                .label = "HEAD~1 " + hostile,
                .machine = {"Example CPU " + hostile, 9007199254740993, "GCC 12", "-O3"}};
  for (const double time : {1e-8 / 3.0, 2e-8}) {
    run.measurements.add({"a/1", "time", "s", Kind::kTime}, time);
  }
  run.measurements.add({"a/1", "instructions", "1", Kind::kCount}, 1234567.0);
  run.measurements.add({"a/1", "cpu_time", "1", Kind::kCount}, 7.0);
  run.measurements.add({"a/1", "digits: error", "1", Kind::kDigits}, 5.25);
  run.measurements.add({"slab/creep@rule=none", "digits: creep", "1", Kind::kDigits}, 0.1 + 0.2);
  run.measurements.add({"slab/creep@rule=none", "verdict: creep", "1", Kind::kVerdict}, 2.0);
  run.measurements.add({"slab/creep@rule=none", "contact updates", "1", Kind::kCount}, 0x1p63);
  run.measurements.add({hostile, hostile + std::string(1, '\0') + "x", hostile, Kind::kOther},
                       5e-324);
  return run;
}

void expect_same(const StoredRun& again, const StoredRun& run) {
  EXPECT_EQ(again.date, run.date);
  EXPECT_EQ(again.revision, run.revision);
  EXPECT_EQ(again.label, run.label);
  EXPECT_EQ(again.machine, run.machine);
  EXPECT_EQ(again.measurements.all().size(), run.measurements.all().size());
  for (const auto& [name, measurement] : run.measurements.all()) {
    const Measurement* const found = again.measurements.find(name);
    ASSERT_NE(found, nullptr) << name;
    EXPECT_EQ(found->metric.subject, measurement.metric.subject);
    EXPECT_EQ(found->metric.unit, measurement.metric.unit);
    EXPECT_EQ(found->metric.kind, measurement.metric.kind);
    EXPECT_EQ(found->samples, measurement.samples) << name;
  }
}

TEST(GoogleJson, ComesBackFromAnExportToTheLastBit) {
  const StoredRun run = full_run();
  const std::string text = to_google_json(run);
  const StoredRun again = run_from_google_json(text, "file");
  expect_same(again, run);
  EXPECT_EQ(to_google_json(again), text);
}

TEST(GoogleJson, ComesBackThroughAHistory) {
  const Scratch scratch;
  History history(scratch.folder() / "history.sqlite");
  const StoredRun run = history.run(history.add(full_run()));
  expect_same(run, full_run());
  const std::string text = to_google_json(run);
  EXPECT_EQ(to_google_json(history.run(history.add(run_from_google_json(text, "file")))), text);
}

// Of benchmarks; for what has no time there is no place.
TEST(GoogleJson, OtherReadersFindTimesAndCounters) {
  const auto benchmarks = nlohmann::json::parse(to_google_json(full_run()))["benchmarks"];
  ASSERT_EQ(benchmarks.size(), 2u);
  EXPECT_EQ(benchmarks[0]["instructions"], 1234567.0);
  EXPECT_EQ(benchmarks[0]["cpu_time"], 1e-8 / 3.0 * 1e9);  // not the counter of that name
  EXPECT_FALSE(benchmarks[1].contains("instructions"));
}

// No run that the history makes has such, but a file's name may be one.
TEST(GoogleJson, WhatIsNoTextIsMarked) {
  StoredRun run = full_run();
  run.label = "bench\xFF.json";
  EXPECT_EQ(run_from_google_json(to_google_json(run), "file").label, "bench\xEF\xBF\xBD.json");
}

TEST(GoogleJson, ReadsExportsFromBeforeOurOwnPart) {
  const StoredRun run = run_from_google_json(
      R"({"benchmarks": [{"name": "a/1", "cpu_time": 5, "repetition_index": 0, "stiction":
          {"instructions": {"unit": "1", "kind": "count", "value": 7}}}]})",
      "file");
  const Measurement* const found = run.measurements.find("a/1#instructions");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->metric.kind, Kind::kCount);
  EXPECT_EQ(found->samples, std::vector<double>{7.0});
}

TEST(GoogleJson, RefusesABrokenExport) {
  const auto refused = [](const char* path, const nlohmann::json& value) {
    auto file = nlohmann::json::parse(to_google_json(full_run()));
    file["stiction"][nlohmann::json::json_pointer(path)] = value;
    EXPECT_THROW(run_from_google_json(file.dump(), "file"), TrackError) << path;
  };
  refused("/version", 2);
  refused("/label", 7);
  refused("/machine", "here");
  refused("/machine/cores", 2.5);
  refused("/version", 1.0);
  refused("/metrics", nlohmann::json::array());
  refused("/metrics/0/kind", "colour");
  refused("/metrics/0/samples", nlohmann::json::array());
  refused("/metrics/0/samples/0", nullptr);
  const auto file = nlohmann::json::parse(to_google_json(full_run()));
  refused("/metrics/1", file["stiction"]["metrics"][0]);
}

TEST(GoogleJson, RefusesOtherText) {
  for (const char* text :
       {"", "[]", "{}", R"({"benchmarks": 1})", R"({"benchmarks": []})",
        R"({"benchmarks": [{"name": "a"}]})",
        R"({"benchmarks": [{"name": "a", "cpu_time": 1, "time_unit": "fortnights"}]})",
        R"({"context": {"num_cpus": 1e300}, "benchmarks": [{"name": "a", "cpu_time": 1}]})",
        R"({"context": {"num_cpus": 18446744073709551615},
            "benchmarks": [{"name": "a", "cpu_time": 1}]})",
        R"({"benchmarks": [{"name": "a", "cpu_time": 1,
            "stiction": {"time": {"unit": "1", "kind": "digits", "value": 3}}}]})",
        R"({"benchmarks": [{"name": "a", "error_occurred": true, "error_message": "no"}]})"}) {
    EXPECT_THROW(run_from_google_json(text, "file"), TrackError) << text;
  }
}

TEST(GoogleJson, SaysWhatIsWrongInOneLine) {
  const char* const text =
      R"({"benchmarks": [{"name": "a", "error_occurred": true, "error_message": "no\nsuch"}]})";
  try {
    run_from_google_json(text, "file");
    ADD_FAILURE() << "it was read";
  } catch (const TrackError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
  }
}

// SQLite keeps a number without fraction as a whole one, which has no sign at 0.
TEST(GoogleJson, HasNoNegativeZero) {
  const StoredRun run =
      run_from_google_json(R"({"benchmarks": [{"name": "a", "cpu_time": -0.0}]})", "file");
  EXPECT_FALSE(std::signbit(run.measurements.find("a#time")->samples.front()));
}

}  // namespace
}  // namespace stiction::track
