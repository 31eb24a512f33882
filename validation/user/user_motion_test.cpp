// SPDX-License-Identifier: GPL-3.0-or-later
// What a file can say of motion, loads, thresholds and sweeps, against formulas.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/testing/test_refusal.h"
#include "validation/core/case_run.h"
#include "validation/user/problem_keys.h"
#include "validation/user/test_user_problem.h"
#include "validation/user/user_case.h"

namespace stiction {
namespace {

using test::kProblem;
using test::UserProblem;
using testing::HasSubstr;

class UserMotion : public UserProblem {
 protected:
  std::string refusal(const std::string& text) {
    return test::refusal([&] { read_user_problem(write(text)); });
  }
  Record result(const std::string& text) { return run(read_user_problem(write(text))); }
  // A point of 2 kg that falls freely from z = 5 m, observed along x at 0.1 s.
  std::string falling(const std::string& observable, const std::string& more) {
    std::string text = edited("rests_on = \"ramp\"", "position = [0, 0, 5]\n" + more);
    const std::size_t at = text.find("\"speed\"");
    return text.replace(at, 7, "\"" + observable + "\"\ndirection = [1, 0, 0]");
  }
};

TEST_F(UserMotion, AForceAcceleratesABody) {
  const Record record =
      result(falling("velocity", "[[load]]\nbody = \"point\"\nforce = [\"40 N\", 0, 0]"));
  EXPECT_NEAR(record.checks.at(0).value, 40.0 / 2.0 * 0.1, 1e-12);
}

TEST_F(UserMotion, ASpringPullsABodyToItsAnchor) {
  const Record record = result(
      falling("velocity",
              "[[spring]]\nbody = \"point\"\nanchor = [1, 0, 5]\naxis = [2, 0, 0]\nstiffness = 2"));
  // ω = 1/s: v = sin t, and the steps' first order.
  EXPECT_NEAR(record.checks.at(0).value, std::sin(0.1), 1e-3);
}

TEST_F(UserMotion, GravityAsASineHasTheVelocityOfItsIntegral) {
  const double omega = 2.0 * std::numbers::pi * 5.0;
  std::string text = falling("velocity", "");
  const std::size_t at = text.find("gravity = [0, 0, -10]");
  text.replace(at, 21,
               "gravity = { constant = [0, 0, -10], amplitude = [3, 0, 0], frequency = 5 }");
  EXPECT_NEAR(result(text).checks.at(0).value, 3.0 / omega * (1.0 - std::cos(0.1 * omega)), 1e-4);
}

TEST_F(UserMotion, AnObstacleThatSwingsTakesAStickingBodyAlong) {
  // Level, μ = 0.5, acceleration at most 0.01 (2π 5)² = 9.9 m/s² · 0.1.
  std::string text = edited("slope_deg = 20",
                            "motion = { amplitude = [\"1 mm\", 0, 0], frequency = 5, full_from = "
                            "0.05 }");
  const std::size_t at = text.find("\"speed\"");
  text.replace(at, 7, "\"position\"\ndirection = [1, 0, 0]\nat = 0.05");
  const double expected = 1e-3 * std::sin(2.0 * std::numbers::pi * 5.0 * 0.05);
  EXPECT_NEAR(result(text).checks.at(0).value, expected, 2e-5);
}

TEST_F(UserMotion, WhatSwingsMustBeginWhereItIs) {
  EXPECT_THAT(refusal(edited("slope_deg = 20",
                             "motion = { time = [0, 1], offset = [[1, 0, 0], [0, 0, 0]] }")),
              HasSubstr("its offset at 0 s is not zero"));
  EXPECT_THAT(refusal(edited("slope_deg = 20", "motion = { amplitude = [1, 0, 0] }")),
              HasSubstr("[motion] lacks 'frequency'"));
  const std::string swings = "motion = { amplitude = [1, 0, 0], frequency = 2, phase_deg = 90";
  EXPECT_THAT(refusal(edited("slope_deg = 20", swings + " }")), HasSubstr("must not jump"));
  EXPECT_EQ(refusal(edited("slope_deg = 20", swings + ", full_from = 1 }")), "");
}

constexpr const char* kThreshold = R"(
[threshold]
vary = "ramp.slope_deg"
holds_at = "20 deg"
fails_at = 35
within = 0.05
expected = 26.565
tolerance = 0.03
reason = "atan 0.5, and half the bracket"
)";

TEST_F(UserMotion, AThresholdIsFoundByBisection) {
  // Sticking, a point still has gained a little by the first step.
  std::string text = edited("tolerance = 1e-12", "tolerance = 1e-6");
  const Record record = result(text + kThreshold);
  EXPECT_EQ(record.error, "");
  ASSERT_EQ(record.checks.size(), 1u);
  EXPECT_EQ(record.checks[0].claim.quantity, "threshold of ramp.slope_deg");
  EXPECT_EQ(record.checks[0].claim.unit, "°");
  EXPECT_EQ(record.verdict, Verdict::kPass) << record.checks[0].value;
  EXPECT_EQ(record.simulations, 2 + 9);
}

TEST_F(UserMotion, AThresholdOutsideItsBracketIsAnError) {
  std::string text = edited("tolerance = 1e-12", "tolerance = 1e-6") + kThreshold;
  const std::size_t at = text.find("fails_at = 35");
  text.replace(at, 13, "fails_at = 25");
  EXPECT_THAT(result(text).error,
              HasSubstr("ramp.toml:25: at ramp.slope_deg = 25 deg every check still holds"));
}

TEST_F(UserMotion, ASweepJudgesEachValue) {
  const Record record = result(std::string(kProblem) +
                               "[sweep]\nvary = \"engine.dt\"\nvalues = [1e-3, 5e-4, 2e-4]\n");
  EXPECT_EQ(record.error, "");
  ASSERT_EQ(record.checks.size(), 3u);
  EXPECT_EQ(record.checks[1].claim.quantity, "speed at engine.dt = 0.0005");
  EXPECT_EQ(record.cost.steps, 100u + 200u + 500u);
}

TEST_F(UserMotion, WhatCannotVaryIsRefused) {
  for (const char* what : {"ramp.colour", "hill.friction", "ramp.name", "ramp.point", "body.mass",
                           "point.force", "ramp.motion.frequency", "ramp.motion", ".force",
                           "point.force.value", "gravity.constant", ""}) {
    EXPECT_THAT(
        refusal(std::string(kProblem) + "[sweep]\nvary = \"" + what + "\"\nvalues = [1]\n"),
        testing::AllOf(HasSubstr("cannot vary"), HasSubstr("; it is to be a number of this file")))
        << what;
  }
}

TEST_F(UserMotion, ASeriesIsDrawnOfWhatIsAskedFor) {
  const Record record =
      result(std::string(kProblem) + "[[series]]\nobservable = \"normal-force\"\n");
  ASSERT_EQ(record.series.size(), 3u);
  EXPECT_EQ(record.series[2].name, "normal-force");
  EXPECT_NEAR(record.series[2].y.back(), 2.0 * 10.0 * std::cos(20.0 * std::numbers::pi / 180.0),
              1e-3);
}

TEST_F(UserMotion, ItIsRecordedForThePlayer) {
  std::string text =
      edited("shape = \"point\"", "shape = \"box\"\nsize = [0.1, 0.1, 0.1]\nyoungs_modulus = 1e4");
  std::optional<Recording> recording;
  const Record record =
      run_job({read_user_problem(write(text)), find_engine("stiction"), {}}, 1.0, &recording);
  EXPECT_EQ(record.error, "");
  ASSERT_TRUE(recording);
  EXPECT_GT(recording->frames.size(), 20u);
}

// Every key that is explained is read: a value of no kind that it could have is refused at its line.
TEST_F(UserMotion, EveryExplainedKeyOfATableIsRead) {
  const std::string wrong = " = 1979-05-27\n";
  const auto reads = [&](const std::string& text, const std::string& key) {
    EXPECT_THAT(refusal(text), HasSubstr("'" + key + "' must be")) << text;
  };
  for (const TomlKey& key : problem_keys::check().keys) {
    const bool of_others = key.name == "from" || key.name == "direction" || key.name == "against";
    if (of_others) continue;  // of other observables
    std::string text = "";
    std::istringstream lines(kProblem);
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with(key.name + " =") || text.find("[[check]]") == std::string::npos)
        text += line + "\n";
    }
    reads(text + key.name + wrong, key.name);
  }
  for (const TomlKey& key : problem_keys::motion().keys) {
    std::string inner = "motion = { ";
    if (key.name == "offset") inner += "time = [0], ";
    if (key.name != "time" && key.name != "offset" && key.name != "constant" &&
        key.name != "velocity" && key.name != "amplitude") {
      inner += "amplitude = [1, 0, 0], ";
      if (key.name != "frequency") inner += "frequency = 1, ";
    }
    if (key.name == "time") inner += "offset = [[0, 0, 0]], ";
    reads(edited("slope_deg = 20", inner + key.name + " = 1979-05-27 }"), key.name);
  }
}

TEST(ProblemHelp, TellsEveryKeyOfEveryTable) {
  const std::string help = problem_help(80);
  for (const TomlKeys* const table : problem_keys::all()) {
    for (const TomlKey& key : table->keys) {
      EXPECT_THAT(help, HasSubstr("  " + key.name + " = ")) << table->table;
    }
  }
}

// tan 20° = 0.364: below the μ of the ramp, above that of the pair.
TEST_F(UserMotion, APairHasAFrictionOfItsOwn) {
  const std::string pair = "\n[[pair]]\nbody = \"point\"\nagainst = \"ramp\"\nfriction = ";
  const std::string check = "[[check]]";
  const auto speed = [&](const std::string& mu) {
    return result(edited(check, pair + mu + "\n" + check)).checks.at(0).value;
  };
  EXPECT_LT(speed("0.5"), 1e-12);
  const double slope = 20.0 * std::numbers::pi / 180.0;
  EXPECT_NEAR(speed("0.1"), 10.0 * 0.1 * (std::sin(slope) - 0.1 * std::cos(slope)), 1e-9);
}

TEST_F(UserMotion, APairIsRefusedThatIsNoneOrGivenTwice) {
  const std::string check = "[[check]]", pair = "[[pair]]\nbody = \"point\"\n";
  const auto told = [&](const std::string& more) {
    return refusal(edited(check, pair + more + "\n" + check));
  };
  EXPECT_THAT(told("against = \"ramp\"\nfriction = -1"), HasSubstr("must not be negative"));
  EXPECT_THAT(told("against = \"floor\"\nfriction = 1"),
              HasSubstr("there is no obstacle 'floor', nor a body of that name above"));
  EXPECT_THAT(told("against = \"point\"\nfriction = 1"),
              HasSubstr("a body touches itself only with self_collision = true"));
  const std::string ramp = "against = \"ramp\"\nfriction = 1\n";
  EXPECT_THAT(told(ramp + pair + ramp), HasSubstr("the friction of these two is given twice"));
}

TEST_F(UserMotion, ARestitutionIsForEnginesThatTakeOne) {
  EXPECT_THAT(refusal(edited("duration = 0.1", "duration = 0.1\nrestitution = 1.5")),
              HasSubstr("'restitution' must lie between 0 and 1"));
  const Record record = result(edited("duration = 0.1", "duration = 0.1\nrestitution = 0.5"));
  EXPECT_EQ(record.verdict, Verdict::kNotApplicable);
  EXPECT_THAT(record.notes.at(0), HasSubstr("the engine has no restitution"));
}

}  // namespace
}  // namespace stiction
