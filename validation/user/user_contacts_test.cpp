// SPDX-License-Identifier: GPL-3.0-or-later
// What can be asked of bodies that touch and move over each other: forces against the weights that
// they carry, motion over another body, the extreme of a window.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/testing/test_refusal.h"
#include "validation/core/case_run.h"
#include "validation/user/test_user_problem.h"
#include "validation/user/user_case.h"

namespace stiction {
namespace {

using test::replaced;
using test::UserProblem;
using testing::HasSubstr;

// Two boxes of 1 kg, one on the other, on a level floor.
constexpr const char* kStack = R"(duration = 0.6
gravity = { time = [0, 0.2], acceleration = [[0, 0, 0], [0, 0, -10]] }
friction = 0.5
drag = { rate = 50, full_until = 0.3, ends = 0.4 }
[[obstacle]]
name = "floor"
friction = 0.5
[[body]]
name = "low"
shape = "box"
size = [0.1, 0.1, 0.1]
mass = 1
damping_time = 1e-3
rests_on = "floor"
[[body]]
name = "top"
shape = "box"
size = [0.1, 0.1, 0.1]
mass = 1
damping_time = 1e-3
rests_on = "low"
)";

std::string check(const std::string& lines) {
  return "[[check]]\nexpected = 0\ntolerance = 9\nreason = \"x\"\n" + lines + "\n";
}

class UserContacts : public UserProblem {
 protected:
  std::string refusal(const std::string& text) {
    return test::refusal([&] { read_user_problem(write(text)); });
  }
  std::vector<double> values(const std::string& text) {
    const Record record = run(read_user_problem(write(text)));
    EXPECT_EQ(record.error, "");
    std::vector<double> all;
    for (const Judgement& one : record.checks) all.push_back(one.value);
    return all;
  }
};

TEST_F(UserContacts, ForcesBetweenBodiesAreFeltByBoth) {
  const std::string force = "observable = \"normal-force\"\nbody = ";
  const std::vector<double> seen = values(
      kStack + check(force + "\"top\"") + check(force + "\"low\"") +
      check(force + "\"low\"\nagainst = \"top\"") + check(force + "\"low\"\nagainst = \"floor\"") +
      check(force + "\"top\"\nagainst = \"floor\""));
  ASSERT_EQ(seen.size(), 5u);
  const double settled = 1e-3;  // N: what still moves
  EXPECT_NEAR(seen[0], 10.0, settled);
  EXPECT_NEAR(seen[1], 30.0, settled) << "10 N from above, 20 N from below";
  EXPECT_NEAR(seen[2], 10.0, settled);
  EXPECT_NEAR(seen[3], 20.0, settled);
  EXPECT_EQ(seen[4], 0.0);
}

TEST_F(UserContacts, FrictionBetweenBodiesActsOnBothOppositely) {
  const std::string push =
      "[[load]]\nbody = \"top\"\nforce = { time = [0.3, 0.4], value = [[0, 0, 0], [2, 0, 0]] }\n";
  const std::string force = "observable = \"friction-force\"\ndirection = [1, 0, 0]\nbody = ";
  const std::vector<double> seen = values(
      kStack + push + check(force + "\"top\"") + check(force + "\"low\"") +
      check(force + "\"low\"\nagainst = \"top\"") + check(force + "\"low\"\nagainst = \"floor\""));
  ASSERT_EQ(seen.size(), 4u);
  const double sways = 0.05;  // N: 1 kg that still sways by so many m/s²
  EXPECT_NEAR(seen[0], -2.0, sways);
  EXPECT_EQ(seen[2], -seen[0]);
  EXPECT_NEAR(seen[3], -2.0, sways);
  EXPECT_NEAR(seen[1], seen[2] + seen[3], 1e-12);
}

// A point that a force swings to and fro.
TEST_F(UserContacts, AnExtremeIsOfAllStepsOfItsWindow) {
  const std::string swings =
      edited("rests_on = \"ramp\"",
             "position = [0, 0, 5]\n[[load]]\nbody = \"point\"\nforce = { amplitude = [40, 0, 0], "
             "frequency = 20 }");
  const std::size_t cut = swings.find("[[check]]");
  const std::string velocity = "observable = \"velocity\"\ndirection = [1, 0, 0]\n";
  const std::vector<double> seen =
      values(swings.substr(0, cut) + check(velocity) + check(velocity + "extreme = \"largest\"") +
             check(velocity + "extreme = \"smallest\"") +
             check(velocity + "extreme = \"largest\"\nfrom = 0.05\nat = 0.06"));
  ASSERT_EQ(seen.size(), 4u);
  // v = F/(m ω) (1 − cos ωt): back at zero after two whole periods, and twice the mean between.
  const double omega = 2.0 * std::numbers::pi * 20.0, mean = 40.0 / 2.0 / omega;
  const double first_order = 20.0 * 1e-3;  // F Δt / m: what a step adds at most
  EXPECT_NEAR(seen[0], 0.0, first_order);
  EXPECT_NEAR(seen[1], 2.0 * mean, first_order);
  EXPECT_NEAR(seen[2], 0.0, first_order);
  EXPECT_NEAR(seen[3], mean * (1.0 - std::cos(0.06 * omega)), first_order);
}

TEST_F(UserContacts, AnExtremeIsOfAnObservableOfOneTime) {
  EXPECT_THAT(refusal(edited("\"speed\"", "\"drift\"\nextreme = \"largest\"")),
              HasSubstr("'extreme' has no effect"));
  EXPECT_THAT(refusal(edited("\"speed\"", "\"speed\"\nextreme = \"biggest\"")),
              HasSubstr("'extreme' is \"largest\" or \"smallest\""));
  EXPECT_THAT(refusal(edited("\"speed\"", "\"speed\"\nfrom = 0.05")),
              HasSubstr("'from' has no effect beside what else [[check]] says; it is: where a "
                        "window begins"));
}

// A point slides down to a stop on level ground: v = v₀ − μ g t.
TEST_F(UserContacts, ASettlingTimeIsWhenItStaysBelow) {
  std::string text = edited("slope_deg = 20", "azimuth_deg = 0");
  text = text.substr(0, text.find("[[check]]"));
  text.replace(text.find("rests_on"), 0, "speed_downhill = 0.25\n");
  const std::string speed = "observable = \"speed\"\nsettles_below = ";
  const std::vector<double> seen =
      values(text + check(speed + "1e-9") + check(speed + "0.1") + check(speed + "0.3") +
             check(speed + "0.1\nfrom = 0.02") + check(speed + "0.1\nat = 0.02") +
             check("observable = \"normal-force\"\nsettles_below = 1"));
  ASSERT_EQ(seen.size(), 6u);
  const double step = 1e-3;
  EXPECT_NEAR(seen[0], 0.05, 1.5 * step);
  EXPECT_NEAR(seen[1], 0.03, 1.5 * step);
  EXPECT_EQ(seen[2], 0.0) << "it was never above";
  EXPECT_NEAR(seen[3], 0.01, 1.5 * step) << "counted from the window's beginning";
  EXPECT_TRUE(std::isinf(seen[4])) << "not yet";
  EXPECT_TRUE(std::isinf(seen[5])) << "never";
}

TEST_F(UserContacts, ASettlingTimeIsOfAnObservableOfOneTime) {
  EXPECT_THAT(refusal(edited("\"speed\"", "\"drift\"\nsettles_below = 1")),
              HasSubstr("'settles_below' has no effect"));
  EXPECT_THAT(refusal(edited("\"speed\"", "\"speed\"\nsettles_below = -1")),
              HasSubstr("'settles_below' must not be negative"));
  EXPECT_THAT(refusal(edited("\"speed\"", "\"speed\"\nsettles_below = 1\nextreme = \"largest\"")),
              HasSubstr("'extreme' has no effect"));
}

TEST_F(UserContacts, MotionCanBeToldOverAnotherThing) {
  std::string text = edited("slope_deg = 20", "motion = { velocity = [0.5, 0, 0] }");
  text += "relative_to = \"ramp\"\n" +
          check("observable = \"velocity\"\ndirection = [1, 0, 0]\nrelative_to = \"ramp\"") +
          check("observable = \"displacement\"\ndirection = [1, 0, 0]\nrelative_to = \"ramp\"") +
          check("observable = \"position\"\ndirection = [0, 0, 1]\nrelative_to = \"ramp\"") +
          check("observable = \"velocity\"\ndirection = [1, 0, 0]");
  const std::vector<double> seen = values(text);
  ASSERT_EQ(seen.size(), 5u);
  // Friction of μ g = 5 m/s² takes the point along: it slips by v²/(2 μ g), but for a step's v Δt, and
  // sinks in by less than a millimetre.
  EXPECT_NEAR(seen[0], 0.0, 1e-9);
  EXPECT_NEAR(seen[1], 0.0, 1e-9);
  EXPECT_NEAR(seen[2], -0.025, 5e-4);
  EXPECT_NEAR(seen[3], 0.0, 1e-3);
  EXPECT_NEAR(seen[4], 0.5, 1e-9);
  const std::string stack =
      kStack + check(
                   "body = \"top\"\nobservable = \"position\"\ndirection = [0, 0, 1]\n"
                   "relative_to = \"low\"");
  EXPECT_NEAR(values(stack).at(0), 0.1, 1e-3);
  EXPECT_THAT(refusal(kStack + check("body = \"top\"\nobservable = \"speed\"\n"
                                     "relative_to = \"top\"")),
              HasSubstr("a body does not move over itself"));
  EXPECT_THAT(refusal(edited("\"speed\"", "\"speed\"\nagainst = \"ramp\"")),
              HasSubstr("'against' has no effect"));
}

TEST_F(UserContacts, NamesSayOfWhatAndOverWhat) {
  const Record record = run(read_user_problem(
      write(kStack +
            check("body = \"top\"\nobservable = \"slip\"\nextreme = \"largest\"\n"
                  "against = \"low\"") +
            check("body = \"top\"\nobservable = \"rotation\"\ndirection = [1, 0, 0]"))));
  ASSERT_EQ(record.checks.size(), 2u);
  EXPECT_EQ(record.checks[0].claim.quantity, "largest slip of top against low");
  EXPECT_EQ(record.checks[1].claim.unit, "°");
}

TEST_F(UserContacts, NothingIsDownhillOnLevelGround) {
  const std::string level = edited("slope_deg = 20\n", "");
  const auto downhill = [](std::string text) {
    return text + "[[check]]\nobservable = \"velocity\"\ndirection = \"downhill\"\n" +
           "expected = 0\ntolerance = 1\nreason = \"x\"\n";
  };
  EXPECT_THAT(refusal(downhill(level)), HasSubstr("'ramp' is level, so nothing is downhill on it"));
  EXPECT_EQ(refusal(downhill(edited("slope_deg = 20", "azimuth_deg = 0"))), "");
  const std::size_t at = level.find("mass");
  EXPECT_THAT(refusal(std::string(level).insert(at, "speed_downhill = 1\n")),
              HasSubstr("what it rests on is level, or stands on no obstacle"));
}

TEST_F(UserContacts, APlaneBesideABodyHoldsNothing) {
  const std::string held =
      "shape = \"box\"\nsize = [0.2, 0.2, 0.1]\nheld = { normal = [0, 0, 1], point = ";
  EXPECT_THAT(
      refusal(edited("shape = \"point\"", held + "[0, 0, -0.06] }")),
      HasSubstr("ramp.toml:17: no part of the body lies below this plane: in its own frame, "
                "whose origin is its centre, it spans (-0.1, -0.1, -0.05) to (0.1, 0.1, "
                "0.05) m"));
  EXPECT_EQ(refusal(edited("shape = \"point\"", held + "[0, 0, -0.05] }")), "");
}

TEST_F(UserContacts, WhatPeopleTryIsToldInTheWordsOfTheFile) {
  EXPECT_THAT(refusal(edited("mass = 2.0", "mass = 2.0\nmotion = { velocity = [1, 0, 0] }")),
              HasSubstr("'motion' has no effect beside what else [[body]] says; it is: moves the "
                        "held part, so it needs `held`"));
  EXPECT_THAT(
      refusal(edited("[[check]]",
                     "[[load]]\nbody = \"point\"\nforce = [1, 0, 0]\npoint = "
                     "[0, 0, 1]\n[[check]]")),
      HasSubstr("[[load]] has no key 'point': a force that acts at r from the centre is its "
                "'force' and a 'couple', r × force"));
}

// Force = mass · acceleration: along its direction, of whatever length it is given.
TEST_F(UserContacts, TheLengthOfALoadAndOfAMotionCanVary) {
  std::string text = edited("rests_on = \"ramp\"",
                            "position = [0, 0, 5]\n[[load]]\nbody = "
                            "\"point\"\nforce = [0, \"-3 mN\", 0]");
  const std::size_t cut = text.find("[[check]]");
  text = text.substr(0, cut) + check("observable = \"velocity\"\ndirection = [0, 1, 0]") +
         "[sweep]\nvary = \"point.force\"\nvalues = [\"40 N\", 20]\n";
  const std::vector<double> seen = values(text);
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_NEAR(seen[0], -2.0, 1e-12);
  EXPECT_NEAR(seen[1], -1.0, 1e-12);

  std::string grows =
      replaced(text, "[0, \"-3 mN\", 0]", "{ time = [0, 0.05], value = [[0, 0, 0], [0, -1, 0]] }");
  grows = replaced(grows, "point.force", "point.force.value");
  const std::vector<double> grown = values(grows);
  ASSERT_EQ(grown.size(), 2u);
  // Half of it on the mean until 0.05 s; off by F Δt / 2 m at most.
  EXPECT_NEAR(grown[0], -40.0 / 2.0 * 0.075, 0.02);
  EXPECT_NEAR(grown[1], -20.0 / 2.0 * 0.075, 0.01);

  std::string moves = edited("slope_deg = 20", "motion = { amplitude = [0, 1, 0], frequency = 5 }");
  moves =
      moves.substr(0, moves.find("[[check]]")) +
      check("observable = \"position\"\ndirection = [0, 1, 0]\nrelative_to = \"ramp\"\nat = 0.05") +
      "[sweep]\nvary = \"ramp.motion.amplitude\"\nvalues = [\"1 m\", 1e-9]\n";
  const std::vector<double> places = values(moves);
  ASSERT_EQ(places.size(), 2u);
  EXPECT_LT(places[0], -0.9) << "it cannot follow";
  EXPECT_NEAR(places[1], 0.0, 1e-9);
}

TEST_F(UserContacts, WithoutContactsThereIsNoSlip) {
  const std::string falls = edited("rests_on = \"ramp\"", "position = [0, 0, 5]");
  const std::string slip = "observable = \"slip\"\nextreme = \"largest\"";
  const Record record = run(read_user_problem(
      write(falls.substr(0, falls.find("[[check]]")) + check(slip) +
            check("observable = \"penetration\"") + check("observable = \"normal-force\""))));
  ASSERT_EQ(record.checks.size(), 3u);
  EXPECT_EQ(record.checks[0].verdict, Verdict::kFail);
  EXPECT_EQ(record.checks[1].verdict, Verdict::kFail);
  EXPECT_EQ(record.checks[2].value, 0.0);
  EXPECT_THAT(record.notes, testing::Contains(HasSubstr("largest slip: there was no contact")));
}

TEST_F(UserContacts, TheStartHasNoContactsYetAndNoExtremeTakesItIn) {
  const std::vector<double> seen = values(
      edited("observable = \"speed\"", "observable = \"normal-force\"\nextreme = \"smallest\""));
  // 2 kg · 10 m/s² · cos 20°, to the digits that stand here.
  EXPECT_NEAR(seen.at(0), 18.794, 5e-4);
}

// A cube that spins freely by 200° and a little more in a second.
TEST_F(UserContacts, ARotationIsJudgedWithoutWholeTurns) {
  const std::string cube = R"(duration = 1
gravity = [0, 0, 0]
[[body]]
name = "cube"
shape = "box"
size = [0.1, 0.1, 0.1]
mass = 1
position = [0, 0, 5]
spin = [0, 0, "200.1 deg/s"]
)";
  const std::string turn =
      "[[check]]\nobservable = \"rotation\"\ndirection = [0, 0, 1]\ntolerance = \"0.5 "
      "deg\"\nreason = \"x\"\n";
  const Record record = run(read_user_problem(write(
      cube + turn + "expected = 200\n" + turn + "expected = -160\n" + turn + "expected = 180\n")));
  ASSERT_EQ(record.checks.size(), 3u);
  EXPECT_EQ(record.checks[0].verdict, Verdict::kPass) << record.checks[0].value;
  EXPECT_EQ(record.checks[1].verdict, Verdict::kPass) << record.checks[1].value;
  EXPECT_EQ(record.checks[2].verdict, Verdict::kFail) << record.checks[2].value;
}

TEST_F(UserContacts, WhatCannotVarySaysWhy) {
  const auto told = [&](const std::string& problem, const std::string& vary) {
    return refusal(problem + "[sweep]\nvary = \"" + vary + "\"\nvalues = [1, 2]\n");
  };
  const std::string load = "[[load]]\nbody = \"point\"\nforce = ";
  const auto with_load = [&](const std::string& more) {
    return edited("[[check]]", more + "\n[[check]]");
  };
  EXPECT_THAT(told(with_load(load + "[0, 0, 0]"), "point.force"),
              HasSubstr("'point.force' cannot vary: it is no number, and no vector with a length"));
  EXPECT_THAT(
      told(with_load(load + "{ time = [0, 1, 2], value = [[0, 0, 0], [1, 0, 0], [2, 0, 0]] }"),
           "point.force.time"),
      HasSubstr("'point.force.time' cannot vary"));
  EXPECT_THAT(told(with_load(load + "{ constant = [1, 0, 0] }"), "point.force"),
              HasSubstr("it is a table, whose keys can"));
  EXPECT_THAT(told(test::kProblem, "friction"), HasSubstr("the file does not give it"));
  EXPECT_EQ(told(edited("slope_deg = 20",
                        "motion = { time = [0, 1], offset = [[0, 0, 0], [0.1, 0, 0]] }"),
                 "ramp.motion.offset"),
            "");
  EXPECT_THAT(told(edited("name = \"point\"", "name = \"ramp\""), "ramp.mass"),
              HasSubstr("cannot vary"));
}

TEST_F(UserContacts, AValueThatTheProblemRefusesIsNamedBeforeItRuns) {
  EXPECT_THAT(refusal(std::string(test::kProblem) +
                      "[sweep]\nvary = \"ramp.slope_deg\"\nvalues = [10, 20]\n"),
              "");
  std::string downhill = edited("\"speed\"", "\"velocity\"\ndirection = \"downhill\"");
  EXPECT_THAT(refusal(downhill + "[sweep]\nvary = \"ramp.slope_deg\"\nvalues = [10, 0]\n"),
              testing::AllOf(HasSubstr("ramp.toml:27: at ramp.slope_deg = 0 deg: "),
                             HasSubstr("'ramp' is level")));
}

}  // namespace
}  // namespace stiction
