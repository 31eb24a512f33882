// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/precision_question.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "validation/comparison/comparison.h"

namespace stiction {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

TEST(PrecisionQuestion, TimeStepsGoFromAboveTheLimitDownToTheFinest) {
  EXPECT_THAT(time_steps_about(3.149e-4, 4e-5), ElementsAre(5e-4, 3.14e-4, 2e-4, 1e-4, 5e-5));
  EXPECT_THAT(time_steps_about(3.149e-4, 1.0), ElementsAre(5e-4, 3.14e-4, 2e-4));
  EXPECT_THAT(time_steps_about(1.5, 0.2), ElementsAre(2.0, 1.5, 1.0, 0.5, 0.2));
  // No step twice where the limit is a round number itself.
  EXPECT_THAT(time_steps_about(2.001e-4, 1e-4), ElementsAre(5e-4, 2e-4, 1e-4));
}

TEST(PrecisionQuestion, TextsOfStepsAreShortAndReadBackAsTheSameNumber) {
  EXPECT_EQ(step_text(2e-4), "2e-4");
  EXPECT_EQ(step_text(3.14e-4), "3.14e-4");
  for (const double dt : time_steps_about(6.303e-4, 1e-7)) EXPECT_EQ(std::stod(step_text(dt)), dt);
}

// f(Δt, h) of first order in Δt and order p in h about 2.
std::vector<std::array<double, 2>> answers(double p, const std::vector<double>& h) {
  std::vector<std::array<double, 2>> f;
  for (const double one : h) {
    const double of_mesh = 2.0 + 0.3 * std::pow(one, p);
    f.push_back({of_mesh + 0.01, of_mesh + 0.005});
  }
  return f;
}

TEST(PrecisionQuestion, ExtrapolationFindsTheLimitWithinItsOwnUncertainty) {
  const std::vector<double> h{0.25, 0.125, 0.0625};
  for (const double p : {1.01, 1.5, 1.99}) {
    const PrecisionReference found = extrapolated(answers(p, h), h);
    EXPECT_NEAR(found.value, 2.0, found.uncertainty) << p;
    // Nearer than the finest mesh; what Δt → 0 changed counts whole.
    EXPECT_LT(found.uncertainty - 0.005, 0.3 * std::pow(h[2], p)) << p;
    EXPECT_GE(found.uncertainty, 0.005) << p;
  }
}

TEST(PrecisionQuestion, WithoutAnOrderInTheMeshTheUncertaintyIsAllThatMeshesDiffer) {
  const std::vector<double> h{0.25, 0.125, 0.0625};
  // A jump at the last mesh, after two that agree.
  const PrecisionReference found = extrapolated({{1.0, 1.0}, {1.0, 1.0}, {1.1, 1.1}}, h);
  EXPECT_DOUBLE_EQ(found.value, 1.1);
  EXPECT_NEAR(found.uncertainty, 0.1, 1e-15);
  // To and fro.
  EXPECT_NEAR(extrapolated({{1.0, 1.0}, {1.3, 1.3}, {1.1, 1.1}}, h).uncertainty, 0.2, 1e-15);
}

// Each question's cases: names that tell their parameters, every method, and a step that the engine
// must refuse.
TEST(PrecisionQuestion, EachHasEveryMethodAndAStepBeyondTheLimit) {
  std::set<std::string> names;
  for (const PrecisionQuestion& question : precision_questions()) {
    EXPECT_TRUE(names.insert(question.name).second) << question.name;
    for (const int cells : question.cells) {
      const StableStep stable = stable_step(question, cells);
      EXPECT_GT(time_steps_about(stable.limit, stable.limit).front(), stable.limit);
    }
  }
  std::set<std::string> found, methods;
  for (const Case& one : comparison_catalog()) {
    if (!one.name.starts_with("work-precision/")) continue;
    EXPECT_EQ(one.set, CaseSet::kFull) << one.name;
    for (const std::string& name : names) {
      if (one.name.starts_with("work-precision/" + name + "/cells=")) found.insert(name);
    }
    for (const Settings& variant : one.variants) methods.insert(variant.at("method"));
  }
  EXPECT_EQ(found, names);
  EXPECT_THAT(methods, ElementsAre("old", "paper", "quiet"));
}

}  // namespace
}  // namespace stiction
