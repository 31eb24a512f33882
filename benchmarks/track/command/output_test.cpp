// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/command/output.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "reports/text/text.h"

namespace stiction::track {
namespace {

using testing::HasSubstr;
using testing::Not;

Outcome outcome() {
  Outcome found{.before = {.id = 3, .revision = "abc", .label = "main"},
                .after = {.id = 4, .revision = "def+", .label = "present"}};
  found.comparisons = {{.metric = {"slab/creep@method=quiet", "digits: creep", "1", Kind::kDigits},
                        .before = 6,
                        .after = 5,
                        .change = Change::kWorse},
                       {.metric = {"friction:secant/slab/contacts:1000", "time", "s", Kind::kTime},
                        .before = 50e-9,
                        .after = 54e-9,
                        .low = 1.07,
                        .high = 1.09,
                        .p = 1e-4,
                        .floor = 0.01,
                        .change = Change::kWorse},
                       {.metric = {"step/slab/contacts:1000", "time", "s", Kind::kTime},
                        .before = 500e-9,
                        .after = 495e-9,
                        .low = 0.98,
                        .high = 1.0,
                        .floor = 0.01},
                       {.metric = {"step/slab/contacts:1000", "instructions", "1", Kind::kCount},
                        .before = 100,
                        .after = 100}};
  return found;
}

TEST(TrackSummary, TellsWhatIsWorseWithEvidenceAndCommand) {
  const std::string text = summary(outcome(), true, {.width = 80});
  EXPECT_THAT(text, HasSubstr("2 worse, 0 better, of 4 metrics"));
  EXPECT_THAT(text, HasSubstr("worse  slab/creep@method=quiet#digits: creep\n"
                              "       6.00 digits → 5.00 digits, -1.00 digits\n"));
  EXPECT_THAT(text, HasSubstr("again: ./stiction validate --case 'slab/creep'\n"));
  EXPECT_THAT(text, HasSubstr("50.00 ns → 54.00 ns, +8.0 %"));
  EXPECT_THAT(text, HasSubstr("p = 0.0001"));
  EXPECT_THAT(text, HasSubstr("again: ./stiction track --against main --benchmark "
                              "'friction:secant/slab/contacts:1000'\n"));
  EXPECT_THAT(text, HasSubstr("1 times differ by -1.0 to -1.0 %"));
  EXPECT_THAT(text, HasSubstr("./stiction track compare 3 4 --all"));
  EXPECT_THAT(text, Not(HasSubstr("#instructions")));
  EXPECT_THAT(summary(outcome(), false, {}), Not(HasSubstr("track compare")));
}

TEST(TrackSummary, UsesAWideScreen) {
  EXPECT_THAT(summary(outcome(), true, {.width = 200}),
              HasSubstr("worse  slab/creep@method=quiet#digits: creep  6.00 digits → 5.00 digits"));
}

}  // namespace
}  // namespace stiction::track
