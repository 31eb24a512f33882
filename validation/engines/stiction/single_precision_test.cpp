// SPDX-License-Identifier: GPL-3.0-or-later
// The solver in single precision (../stiction_single/), through the engine protocol.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "reference/process/child.h"
#include "validation/engine/build_of.h"
#include "validation/engines/stiction/configurations.h"
#include "validation/engines/stiction/test_engine.h"

namespace stiction {
namespace {

EngineKind single_precision() {
  return find_engine((reference::folder_of_this_program() / "engine_stiction_single").string());
}

TEST(SinglePrecision, IsTheSameSolverToItsOwnDigits) {
  const Problem problem = incline_problem(test::slope(0.6, 0.5));
  const auto one = single_precision().make({}), two = find_engine("stiction").make({});
  for (const auto& engine : {one.get(), two.get()}) {
    engine->load(problem, {});
    engine->advance(500);
  }
  EXPECT_EQ(one->time_step(), two->time_step());
  EXPECT_EQ(one->settings().at("rule"), two->settings().at("rule"));
  EXPECT_EQ(one->contacts().size() > 0, two->contacts().size() > 0);
  // Of a way of 0.06 m: a depth of 4e-7 m, whose last digit is 7e-9 m, leaves a friction force two
  // digits in a step, and some four over many.
  const double apart = (one->body(0).position - two->body(0).position).norm();
  EXPECT_LT(apart, 1e-4);
  EXPECT_GT(apart, 1e-12);  // else it is in double precision
}

TEST(SinglePrecision, GoesOnFromASavedState) {
  const auto engine = single_precision().make({});
  engine->load(incline_problem(test::slope(0.6)), {});
  engine->advance(100);
  const Snapshot saved = engine->save();
  engine->advance(100);
  const std::uint64_t hash = engine->state_hash();
  engine->restore(saved);
  engine->advance(100);
  EXPECT_EQ(engine->state_hash(), hash);
}

TEST(SinglePrecision, HasTheConfigurationsOfTheSolverAndNoExpectations) {
  const EngineKind kind = single_precision();
  EXPECT_TRUE(kind.expectations.empty());
  std::vector<std::string> told, known;
  for (const Configuration& one : kind.configurations("any")) told.push_back(one.name);
  for (const Configuration& one : method_configurations()) known.push_back(one.name);
  EXPECT_EQ(told, known);
  EXPECT_THAT(told, testing::ElementsAre("quiet", "paper, fixed point", "paper, secant", "old"));
}

// Both answer at the same efforts, so that their curves lie over each other point by point.
TEST(SinglePrecision, HasTheLadderOfTheSolver) {
  EXPECT_FALSE(single_precision().ladder.empty());
  EXPECT_EQ(single_precision().ladder, find_engine("stiction").ladder);
}

TEST(SinglePrecision, IsABuildOfTheSolver) {
  EXPECT_EQ(build_of(find_engine("stiction"), "single").name, "stiction_single");
  EXPECT_THROW(build_of(find_engine("stiction"), "half"), NotApplicable);
  EXPECT_THROW(build_of(find_engine("plain"), "single"), NotApplicable);
}

}  // namespace
}  // namespace stiction
