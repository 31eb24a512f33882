// SPDX-License-Identifier: GPL-3.0-or-later
// Problems that would pass wrongly, or for ever: each is refused, or fails.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "solver/testing/test_refusal.h"
#include "validation/core/case_run.h"
#include "validation/user/test_user_problem.h"
#include "validation/user/user_case.h"

namespace stiction {
namespace {

using test::kProblem;
using test::replaced;
using test::UserProblem;
using testing::HasSubstr;

class UserTrap : public UserProblem {
 protected:
  std::string refusal(const std::string& text) {
    return test::refusal([&] { read_user_problem(write(text)); });
  }
  Record result(const std::string& text) { return run(read_user_problem(write(text))); }
};

// A level floor before a ramp of 35°, which a box slides down: downhill is the ramp's.
constexpr const char* kTwoObstacles = R"(duration = 0.2
gravity = [0, 0, -10]
[engine]
dt = 1e-3
[[obstacle]]
name = "floor"
point = [0, 0, -10]
friction = 0.5
[[obstacle]]
name = "ramp"
slope_deg = 35
azimuth_deg = 90
friction = 0.3
[[body]]
name = "box"
shape = "point"
mass = 1
rests_on = "ramp"
[[check]]
observable = "mean-velocity"
direction = "downhill"
expected = 0.0
tolerance = 1e-9
reason = "it does not slide"
)";

TEST_F(UserTrap, DownhillIsThatOfWhatTheBodyRestsOn) {
  const Record record = result(kTwoObstacles);
  EXPECT_EQ(record.verdict, Verdict::kFail);
  // Half the time at g (sin 35° − 0.3 cos 35°).
  EXPECT_NEAR(record.checks.at(0).value, 0.1 * 10 * (std::sin(0.6109) - 0.3 * std::cos(0.6109)),
              5e-3);
}

TEST_F(UserTrap, DownhillOfNoBodyThatRestsSomewhereIsAskedForByName) {
  const std::string placed = replaced(kTwoObstacles, "rests_on = \"ramp\"", "position = [0, 0, 1]");
  EXPECT_THAT(refusal(placed), HasSubstr("'box' rests on no obstacle by its 'rests_on': say of "
                                         "which it is downhill, { downhill = \"NAME\" }; there "
                                         "are: floor, ramp"));
  const std::string named =
      replaced(placed, "direction = \"downhill\"", "direction = { downhill = \"ramp\" }");
  EXPECT_EQ(refusal(named), "");
  EXPECT_THAT(refusal(replaced(named, "{ downhill = \"ramp\" }", "{ downhill = \"hill\" }")),
              HasSubstr("there is no obstacle 'hill'"));
}

std::string with_second(const std::string& lines) {
  return replaced(kProblem, "[[check]]", lines + "\n[[check]]\nbody = \"point\"");
}

TEST_F(UserTrap, BodiesThatBeginInsideEachOtherAreRefused) {
  const std::string brick =
      "shape = \"box\"\nsize = [0.2, 0.2, 0.1]\nmass = 1\nrests_on = \"ramp\"\n";
  const std::string two = "[[body]]\nname = \"a\"\n" + brick + "[[body]]\nname = \"b\"\n" + brick;
  const std::string text =
      replaced(with_second(two), "rests_on = \"ramp\"", "position = [0, 0, 9]");
  EXPECT_THAT(refusal(text), HasSubstr("'a' and 'b' begin inside each other, by at least"));
  EXPECT_EQ(refusal("initial_overlap = \"allowed\"\n" + text), "");
  const std::string apart =
      replaced(text, "name = \"b\"", "name = \"b\"\noffset = [\"20 cm\", 0, 0]");
  EXPECT_EQ(refusal(apart), "") << "side by side, face on face";
  EXPECT_THAT(refusal(replaced(apart, "20 cm", "199.99 mm")), HasSubstr("begin inside each other"));
}

TEST_F(UserTrap, ABodyInAnObstacleIsRefused) {
  EXPECT_THAT(refusal(edited("rests_on = \"ramp\"", "position = [0, 0, -1]")),
              HasSubstr("'point' begins 0.94 m inside obstacle 'ramp'"));
}

TEST_F(UserTrap, ABodyThatRestsOnItselfIsRefused) {
  EXPECT_THAT(refusal(edited("rests_on = \"ramp\"", "rests_on = \"point\"")),
              HasSubstr("there is no obstacle 'point', nor a body of that name above; obstacles: "
                        "ramp; bodies: none"));
}

TEST_F(UserTrap, AStackOfBodiesStandsFlushAndSharesItsDownhill) {
  const std::string brick = "shape = \"box\"\nsize = [0.2, 0.2, 0.1]\nmass = 1\n";
  const std::string stack = "[[body]]\nname = \"a\"\n" + brick +
                            "rests_on = \"ramp\"\n[[body]]\nname = \"b\"\n" + brick +
                            "rests_on = \"a\"\nrotation = { axis = [1, 0, 0], angle_deg = 90 }\n";
  std::string text = replaced(with_second(stack), "rests_on = \"ramp\"", "position = [0, 0, 9]");
  text = replaced(text, "observable = \"speed\"",
                  "observable = \"velocity\"\ndirection = \"downhill\"");
  text = replaced(text, "body = \"point\"", "body = \"b\"");
  const UserCase read = read_user_problems({write(text).string()}).front();
  const Problem& problem = read.problem->problem;
  const Eigen::Vector3d up = problem.obstacles[0].normal;
  // Its own height is 0.2 m as it lies on its side.
  EXPECT_NEAR(up.dot(problem.bodies[2].position), 0.1 + 0.1, 1e-15);
  EXPECT_NEAR(read.problem->checks.at(0).watch.direction.dot(up), 0.0, 1e-15);
  EXPECT_LT(read.problem->checks.at(0).watch.direction.z(), 0.0);
}

TEST_F(UserTrap, ADurationBelowAStepSimulatesNothingAndIsAnError) {
  const Record record = result(edited("duration = 0.1", "duration = 1e-4"));
  EXPECT_EQ(record.verdict, Verdict::kError);
  EXPECT_THAT(record.error, HasSubstr("the duration, 0.0001 s, is shorter than a step"));
}

TEST_F(UserTrap, ADurationWithoutEndIsAnError) {
  const Record record = result(edited("duration = 0.1", "duration = 1e308"));
  EXPECT_EQ(record.verdict, Verdict::kError);
  EXPECT_THAT(record.error, HasSubstr("more than can be counted"));
}

TEST_F(UserTrap, AWindowInsideOneStepIsAnError) {
  const Record record = result(
      edited("\"speed\"", "\"mean-velocity\"\ndirection = \"downhill\"\nfrom = 0.05\nat = 0.0503"));
  EXPECT_EQ(record.verdict, Verdict::kError);
  EXPECT_THAT(record.error,
              HasSubstr("ramp.toml:19: from = 0.05 s and at = 0.0503 s are the same step"));
}

TEST_F(UserTrap, ATimeBeforeTheFirstStepIsAnError) {
  const Record record = result(edited("\"speed\"", "\"speed\"\nat = 1e-5"));
  EXPECT_EQ(record.verdict, Verdict::kError);
  EXPECT_THAT(record.error, HasSubstr("at = 1e-05 s is the start"));
}

TEST_F(UserTrap, WhatTakesLongerThanItMayIsGivenUp) {
  Job job{read_user_problem(write(edited("duration = 0.1", "duration = 1e6"))),
          find_engine("stiction"),
          {}};
  job.cpu_limit = 0.2;
  const Record record = run_job(job, 1.0);
  EXPECT_EQ(record.verdict, Verdict::kError);
  EXPECT_THAT(record.error, HasSubstr("its CPU time is used up"));
  EXPECT_LT(record.cost.cpu_seconds, 0.5);
}

TEST_F(UserTrap, AKeyThatHasNoEffectIsRefused) {
  EXPECT_THAT(refusal(edited("mass = 2.0", "mass = 2.0\nradius = 3")),
              HasSubstr(":17: 'radius' has no effect beside what else [[body]] says"));
  EXPECT_THAT(refusal(edited("mass = 2.0", "mass = 2.0\nvelocity = [1, 0, 0]")),
              HasSubstr("'velocity' has no effect"));
}

TEST_F(UserTrap, ChecksOfTwoBodiesHaveNamesOfTheirOwn) {
  const std::string second =
      "[[body]]\nname = \"other\"\nshape = \"point\"\nmass = 1\nposition = [0, 0, 5]\n";
  const std::string check =
      "[[check]]\nobservable = \"speed\"\nexpected = 1\ntolerance = 9\nreason = \"x\"\n";
  EXPECT_THAT(refusal(replaced(kProblem, "[[check]]", second + "[[check]]")),
              HasSubstr("which 'body' is observed? There are: point, other"));
  const Record record =
      result(with_second(second) + check + "body = \"other\"\n" + check +
             "body = \"other\"\nat = 0.05\n" + check + "body = \"other\"\nat = 0.05\n");
  std::vector<std::string> names;
  for (const Judgement& one : record.checks) names.push_back(one.claim.quantity);
  EXPECT_THAT(names,
              testing::ElementsAre("speed of point", "speed of other at 0.1 s",
                                   "speed of other at 0.05 s (1)", "speed of other at 0.05 s (2)"));
}

TEST_F(UserTrap, FilesOfOneNameAreCasesOfTheirOwn) {
  std::filesystem::create_directories(folder_ / "a");
  std::filesystem::create_directories(folder_ / "b");
  for (const char* name : {"a/ramp.toml", "b/ramp.toml", "b/other.toml"}) {
    std::ofstream(folder_ / name) << kProblem;
  }
  const auto path = [&](const char* name) { return (folder_ / name).string(); };
  const auto cases =
      read_user_problems({path("a/ramp.toml"), path("b/ramp.toml"), path("b/other.toml")});
  EXPECT_EQ(cases[0].which.name, "user/a/ramp");
  EXPECT_EQ(cases[1].which.name, "user/b/ramp");
  EXPECT_EQ(cases[2].which.name, "user/other");
  EXPECT_THAT(test::refusal([&] {
                read_user_problems({path("a/ramp.toml"), path("a/../a/ramp.toml")});
              }),
              HasSubstr("is given twice"));
}

TEST_F(UserTrap, AKeyOfAHundredThousandPartsIsRefused) {
  std::string parts;
  for (int k = 0; k < 100000; ++k) parts += "a.";
  EXPECT_THAT(refusal(std::string(kProblem) + parts + "b = 1\n"),
              HasSubstr("a key has more than 64 parts"));
  EXPECT_THAT(refusal(std::string(kProblem) + "[" + parts + "b]\n"),
              HasSubstr("a key has more than 64 parts"));
  std::string numbers = "title = \"" + std::string(1000, '.') + "\"\n";
  EXPECT_EQ(refusal(replaced(kProblem, "title = \"a point on a ramp\"\n", numbers)), "")
      << "no key";
}

TEST_F(UserTrap, TwentyThousandBodiesAreReadInSeconds) {
  std::string bodies;
  for (int k = 0; k < 20000; ++k) {
    bodies += "[[body]]\nname = \"b" + std::to_string(k) +
              "\"\nshape = \"point\"\nmass = 1\nposition = [" + std::to_string(k) + ", 0, 99999]\n";
  }
  EXPECT_EQ(refusal(with_second(bodies)), "");
}

}  // namespace
}  // namespace stiction
