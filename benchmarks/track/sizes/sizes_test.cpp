// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/sizes/sizes.h"

#include <gtest/gtest.h>

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
          .limits = {1.1e-6, 2.2e-6}};
}

double value(const Record& record, const std::string& name) {
  for (const Series& series : record.series) {
    if (series.name == name) return series.y.at(0);
  }
  ADD_FAILURE() << "no series " << name;
  return 0.0;
}

TEST(Sizes, CostsAreMediansPerContact) {
  const SizeResult result = result_of();
  EXPECT_NEAR(step_nanoseconds(*result.of("before")), 500.0, 1e-9);
  EXPECT_NEAR(step_nanoseconds(*result.of("now")), 200.0, 1e-9);
  EXPECT_NEAR(phase_nanoseconds(*result.of("before"), {"forces", "detect", "no phase"}), 600.0,
              1e-9);
  EXPECT_EQ(result.of("nonsense"), nullptr);
}

TEST(Sizes, RatiosAreOfTheSameTurnAndPerContact) {
  const SizeResult result = result_of();
  const reference::Quartiles of_it = ratio(*result.of("now"), *result.of("before"));
  EXPECT_NEAR(of_it.median, 4.0 / 9.0, 1e-12);  // of 0.5, 0.2 and 0.44
  EXPECT_NEAR(of_it.upper, 0.5 * (4.0 / 9.0 + 0.5), 1e-12);
  EXPECT_NEAR(ratio(*result.of("now"), *result.of("2 threads"), true).median, 2.0, 1e-12);
}

TEST(Sizes, RecordHasEachWayAndWhatTheMachineAllows) {
  const Record record =
      family_record({result_of()}, {.label = "old", .revision = "0123", .build = {}}, {});
  EXPECT_EQ(record.case_name, "sizes/slab");
  EXPECT_EQ(record.settings.at("before"), "0123");
  EXPECT_EQ(record.verdict, Verdict::kPass);
  EXPECT_NEAR(value(record, "step, now per contact"), 2e-7, 1e-18);
  EXPECT_NEAR(value(record, "detection and depth, before per contact"), 4e-7, 1e-18);
  EXPECT_NEAR(value(record, "step, registers of 2 per contact"), 3e-7, 1e-18);
  EXPECT_NEAR(value(record, "gain by 2 threads"), 2.0, 1e-12);
  EXPECT_NEAR(value(record, "step, least by bandwidth per contact"), 1e-7, 1e-18);
  EXPECT_NEAR(value(record, "step, least by arithmetic per contact"), 2e-7, 1e-18);
}

TEST(Sizes, AnotherStateOfThreadsFails) {
  SizeResult result = result_of();
  result.times[3].hash = "fedcba9876543210";
  const Record record = family_record({result}, {.label = {}, .revision = {}, .build = {}}, {});
  EXPECT_EQ(record.verdict, Verdict::kFail);
  EXPECT_EQ(worst_check(record.checks)->worst, "step/slab/contacts:10 2 threads");
}

TEST(Sizes, AStateThatIsNotAlwaysTheSameFails) {
  SizeResult result = result_of();
  for (StepTimes& times : result.times) times.hash.clear();
  const Record record = family_record({result}, {.label = {}, .revision = {}, .build = {}}, {});
  EXPECT_EQ(record.verdict, Verdict::kFail);
  EXPECT_NE(record.notes.at(0).find("of 0 of 1"), std::string::npos) << record.notes.at(0);
}

TEST(Sizes, AnotherStateOfTheOldRevisionIsNoFault) {
  SizeResult result = result_of();
  result.times[0].hash = "fedcba9876543210";
  EXPECT_EQ(family_record({result}, {.label = {}, .revision = {}, .build = {}}, {}).verdict,
            Verdict::kPass);
}

}  // namespace
}  // namespace stiction::track
