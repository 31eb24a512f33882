// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/sizes/sizes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "benchmarks/track/sizes/sizes_output.h"

namespace stiction::track {
namespace {

StepTimes times_of(double contacts, std::vector<double> cpu, std::vector<double> wall) {
  StepTimes times;
  times.settled = {.contacts = contacts, .at_rest = true, .error = 0.01};
  times.cpu = std::move(cpu);
  times.wall = std::move(wall);
  times.phases = {{"forces", {1e-6, 2e-6, 9e-6}}, {"detect", {4e-6, 4e-6, 4e-6}}};
  times.hash = "0123456789abcdef";
  return times;
}

// One revision found a contact in ten that the other didn't, and two threads halve the time on the wall.
SizeResult result_of() {
  return {.workload = {"slab", 10},
          .ways = {{"before", "old"},
                   {"now", "new"},
                   {"registers of 2", "new", 2},
                   {"2 threads", "new", 0, 2}},
          .times = {times_of(10.0, {4e-6, 5e-6, 9e-6}, {4e-6, 5e-6, 9e-6}),
                    times_of(11.0, {2.2e-6, 1.1e-6, 4.4e-6}, {2e-6, 1e-6, 4e-6}),
                    times_of(11.0, {3.3e-6, 3.3e-6, 3.3e-6}, {3.3e-6, 3.3e-6, 3.3e-6}),
                    times_of(11.0, {2.2e-6, 2.2e-6, 2.2e-6}, {1e-6, 0.5e-6, 2e-6})},
          .limits = {1.1e-6, 2.2e-6},
          .together = {{{{55e-9, 1.9}, {60e-9, 1.8}}},
                       {{{480e-9, 1.5}, {61e-9, 1.8}}},
                       {{{60e-9, 1.8}, {60e-9, 1.9}}}}};
}

const Tree kOld{.label = "old", .revision = "0123", .build = {}};

const Record& record_of(const std::vector<Record>& records, const std::string& configuration) {
  for (const Record& record : records) {
    if (record.configuration == configuration) return record;
  }
  throw std::runtime_error("no record of " + configuration);
}

// In units of 1e-9.
double value(const Record& record, const std::string& name) {
  for (const Series& series : record.series) {
    if (series.name == name) return 1e9 * series.y.at(0);
  }
  throw std::runtime_error("no series " + name);
}

TEST(Sizes, CostsAreMediansPerContact) {
  const SizeResult result = result_of();
  EXPECT_NEAR(step_nanoseconds(result.before()), 500.0, 1e-9);
  EXPECT_NEAR(step_nanoseconds(result.now()), 200.0, 1e-9);
  EXPECT_NEAR(phase_nanoseconds(result.before(), {"forces", "detect", "no phase"}), 600.0, 1e-9);
}

TEST(Sizes, RatiosAreOfTheSameTurnAndPerContact) {
  const SizeResult result = result_of();
  const reference::Quartiles of_it = ratio(result.now(), result.before());
  EXPECT_NEAR(of_it.median, 4.0 / 9.0, 1e-12);  // of 0.5, 0.2 and 0.44
  EXPECT_NEAR(of_it.upper, 0.5 * (4.0 / 9.0 + 0.5), 1e-12);
  EXPECT_NEAR(ratio(result.now(), result.times[3], true).median, 2.0, 1e-12);
}

TEST(Sizes, WhatThreadsGainNearEachOtherIsOfTurnsThatBeganAndEndedSo) {
  SizeResult result = result_of();
  const auto near = [&] { return ratio_near(result, result.now(), result.times[3]); };
  EXPECT_TRUE(std::isnan(near()));  // two turns alone
  const auto turn = [&](double wall, double before, double after) {
    result.times[1].wall.push_back(2e-6);
    result.times[3].wall.push_back(wall);
    result.together.push_back({{{before, 1.9}, {after, 1.9}}});
  };
  turn(0.5e-6, 60e-9, 480e-9);
  EXPECT_TRUE(std::isnan(near()));
  turn(0.5e-6, 0.0, 0.0);  // of one processor
  EXPECT_TRUE(std::isnan(near()));
  turn(0.8e-6, 60e-9, 399e-9);
  EXPECT_NEAR(near(), 2.0, 1e-12);  // of 2, 2 and 2.5
  turn(0.8e-6, 55e-9, 60e-9);
  EXPECT_NEAR(near(), 2.25, 1e-12);
}

TEST(Sizes, RecordsHaveEachWayAndWhatTheMachineAllows) {
  const std::vector<Record> records = family_records({result_of()}, kOld, {});
  ASSERT_EQ(records.size(), 6U);
  for (const Record& record : records) {
    EXPECT_EQ(record.case_name, "sizes/slab");
    EXPECT_EQ(record.settings.at("before"), "0123");
    EXPECT_NE(record.verdict, Verdict::kFail);
  }
  const auto step_of = [&](const char* way) {
    return value(record_of(records, way), "whole step per contact");
  };
  EXPECT_NEAR(step_of("before"), 500.0, 1e-9);
  EXPECT_NEAR(step_of("now"), 200.0, 1e-9);
  EXPECT_NEAR(step_of("registers of 2"), 300.0, 1e-9);
  EXPECT_NEAR(step_of("2 threads"), 1e3 / 11.0, 1e-9);  // by the clock on the wall
  EXPECT_NEAR(step_of("least by bandwidth"), 100.0, 1e-9);
  EXPECT_NEAR(step_of("least by arithmetic"), 200.0, 1e-9);
  EXPECT_NEAR(value(record_of(records, "before"), "detection and depth per contact"), 400.0, 1e-9);
  EXPECT_NEAR(value(record_of(records, "now"), "whole step, now ÷ before"), 4e9 / 9.0, 1e-3);
  EXPECT_NEAR(value(record_of(records, "2 threads"), "times as fast as one thread"), 2e9, 1e-3);
  EXPECT_NEAR(value(record_of(records, "2 threads"), "answer of another processor"), 60.0, 1e-9);
  EXPECT_NEAR(value(record_of(records, "2 threads"), "arithmetic, times as fast as one"), 1.8e9,
              1e-3);
}

TEST(Sizes, RecordsTellWhatThreadsGainNearEachOtherWhereTheyEverWere) {
  SizeResult result = result_of();
  const auto near = [&result] {
    return value(record_of(family_records({result}, kOld, {}), "2 threads"),
                 "times as fast as one thread, near each other");
  };
  EXPECT_THROW(near(), std::runtime_error);  // else an empty diagram
  result.together[1][0].answer_seconds = 60e-9;
  EXPECT_NEAR(near(), 2e9, 1e-3);
}

TEST(Sizes, AnotherStateOfThreadsFails) {
  SizeResult result = result_of();
  result.times[3].hash = "fedcba9876543210";
  const std::vector<Record> records = family_records({result}, kOld, {});
  EXPECT_EQ(record_of(records, "2 threads").verdict, Verdict::kFail);
  EXPECT_EQ(worst_check(record_of(records, "2 threads").checks)->worst, "step/slab/contacts:10");
  EXPECT_EQ(record_of(records, "registers of 2").verdict, Verdict::kPass);
}

TEST(Sizes, AStateThatIsNotAlwaysTheSameFails) {
  SizeResult result = result_of();
  for (StepTimes& times : result.times) times.hash.clear();
  const Record now = record_of(family_records({result}, kOld, {}), "now");
  EXPECT_EQ(now.verdict, Verdict::kFail);
  EXPECT_EQ(now.notes.at(0),
            "10 contacts: 0.444 of what it took, half of the turns 0.322 to 0.472");
  EXPECT_NE(now.notes.back().find("of 0 of 1"), std::string::npos) << now.notes.back();
}

TEST(Sizes, AnotherStateOfTheOldRevisionIsNoFault) {
  SizeResult result = result_of();
  result.times[0].hash = "fedcba9876543210";
  for (const Record& record : family_records({result}, kOld, {})) {
    EXPECT_NE(record.verdict, Verdict::kFail) << record.configuration;
  }
}

}  // namespace
}  // namespace stiction::track
