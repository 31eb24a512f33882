// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/engines/engine_summary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "validation/comparison/engines/questions.h"

namespace stiction {
namespace {

using testing::HasSubstr;
using testing::Not;

// What an engine answered; NaN: it broke.
Record answer(const std::string& id, const std::string& engine, double error, double seconds) {
  Record one;
  one.case_name = "engines/" + id;
  one.engine = engine;
  one.settings = {{"engine", engine}, {"configuration", "default"}};
  one.verdict = Verdict::kForInformation;
  if (std::isnan(error)) {
    one.failures.push_back({.reason = "crashed"});
    return one;
  }
  one.figures = {{"error", "1", "", error}, {"CPU time", "s", "", seconds}};
  one.cost.cpu_seconds = seconds;
  return one;
}

std::vector<Question> three_questions() {
  std::vector<Question> chosen;
  for (const Question& one : engine_questions()) {
    if (one.id == "creep-30" || one.id == "gives-30" || one.id == "stops-30") chosen.push_back(one);
  }
  return chosen;
}

TEST(EngineSummary, TellsWhoHoldsWhoDoesNotAndWhoIsCloser) {
  const std::vector<Record> made = {
      answer("creep-30", "stiction", 0.0, 0.3),       answer("creep-30", "swift", 0.0, 0.01),
      answer("creep-30", "slack", 1e-4, 0.01),        answer("gives-30", "stiction", -2e-5, 0.3),
      answer("gives-30", "swift", 2e-5, 0.01),        answer("gives-30", "slack", 4.5, 0.01),
      answer("stops-30", "stiction", -4e-3, 0.3),     answer("stops-30", "swift", -1e-3, 0.01),
      answer("stops-30", "slack", std::nan(""), 0.01)};
  const std::string text = engine_summary(EngineAnswers(three_questions(), made), {.width = 200});
  EXPECT_THAT(text, HasSubstr("2 of 3 hold"));
  // The cheaper one first.
  EXPECT_LT(text.find("swift · default"), text.find("stiction · default"));
  EXPECT_THAT(text, HasSubstr("slack · default (0.0001; 4.5)"));
  EXPECT_THAT(text, HasSubstr("stops-30: swift · default -0.001, ours -0.004"));
  EXPECT_THAT(text, Not(HasSubstr("creep-30: swift")));  // both are right
  EXPECT_THAT(text, HasSubstr("./stiction compare engines --engine 'slack' --question stops-30"));
}

}  // namespace
}  // namespace stiction
