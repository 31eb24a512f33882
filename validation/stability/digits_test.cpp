// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/stability/digits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace stiction {
namespace {

using testing::HasSubstr;

std::vector<Observation> run(double a, double b) {
  return {{"slope", "1", a, 0.5}, {"way", "m", b, 2.0}};
}

TEST(Deviation, IsTheStandardDeviationOverTheScaleOfTheWorst) {
  const Deviation found =
      deviation({run(0.5, 1.0), run(0.5, 1.2), run(0.5, 1.1)}, {"as it is", "so", "otherwise"});
  EXPECT_NEAR(found.absolute, 0.1, 1e-15);
  EXPECT_NEAR(found.relative, 0.05, 1e-15);
  EXPECT_THAT(found.worst, HasSubstr("way: 1.2 m, not 1, when so"));
}

TEST(Deviation, OfEqualRunsIsNothing) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(deviation({run(0.1, infinity), run(0.1, infinity)}, {"", ""}).relative, 0.0);
}

TEST(Deviation, OfWhatIsNoNumberIsInfinite) {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(deviation({run(0.1, 1.0), run(0.1, infinity)}, {"", "so"}).relative, infinity);
  EXPECT_EQ(deviation({run(0.1, 1.0), run(nan, 1.0)}, {"", "so"}).relative, infinity);
  EXPECT_EQ(deviation({run(0.1, 1.0), {}}, {"", "so"}, true).relative, infinity)
      << "nothing in common is nothing that survives";
}

TEST(Deviation, SeesANumberThatIsNoneBetweenEqualOnes) {
  const double nan = std::nan("");
  EXPECT_TRUE(std::isinf(deviation({run(1, 1), run(nan, 1), run(1, 1)}, {"", "", ""}).relative));
}

TEST(Deviation, MayLackAFigureOnlyWhereThatIsSaid) {
  std::vector<Observation> less = run(0.5, 1.0);
  less.pop_back();
  EXPECT_TRUE(std::isinf(deviation({run(0.5, 1.0), less}, {"", "so"}).relative));
  EXPECT_EQ(deviation({run(0.5, 1.0), less}, {"", "so"}, true).relative, 0.0);
}

TEST(Deviation, SeesATurnAboutAnyAxis) {
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
    const auto turned = [&](double angle) {
      BodyMotion body{Vec3::Zero(), Vec3::Zero()};
      body.rotation = Eigen::AngleAxisd(angle, axis);
      PerturbedTrace trace;
      trace.ends.push_back({.bodies = {body}, .sizes = {1.0}});
      return observations_of({}, trace);
    };
    EXPECT_NEAR(deviation({turned(0.0), turned(1e-3)}, {"", "so"}).relative, 1e-3 / std::sqrt(2.0),
                1e-6);
  }
}

TEST(Observations, AreFiguresWithAScaleAndEndsOfFewSimulations) {
  Record record;
  Judgement check;
  check.claim = {.quantity = "drift", .unit = "m", .expected = 0.0};
  check.value = 1e-9;
  record.checks.push_back(check);  // no scale
  check.claim = {.quantity = "way", .unit = "m", .expected = 1e-6};
  record.checks.push_back(check);
  check.claim = {.quantity = "order", .unit = "1", .expected = 1.0, .derived = true};
  record.checks.push_back(check);
  PerturbedTrace trace;
  const BodyMotion body{Vec3(1, 2, 3), Vec3::Zero()};
  trace.ends.push_back({.bodies = {body}, .sizes = {0.1}, .length = 0.5});
  const std::vector<Observation> all = observations_of(record, trace);
  ASSERT_EQ(all.size(), 1u + 3 + 3 + 6);
  EXPECT_EQ(all[0].name, "way");
  EXPECT_EQ(all[0].scale, 0.5) << "a short way is a difference of places";
  EXPECT_EQ(all[1].value, 1.0);
  EXPECT_EQ(all[7].scale, 5.0) << "a turn is a difference of places across a fifth of the width";
  trace.ends.resize(6, trace.ends[0]);
  EXPECT_EQ(observations_of(record, trace).size(), 1u) << "a search";
}

}  // namespace
}  // namespace stiction
