// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong in a file is told with the file and the line; what no scene can be made of, by the
// record.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/testing/test_refusal.h"
#include "validation/user/test_user_problem.h"
#include "validation/user/user_case.h"

namespace stiction {
namespace {

namespace fs = std::filesystem;
using test::kProblem;
using test::UserProblem;
using testing::AllOf;
using testing::HasSubstr;

TEST_F(UserProblem, ThatCannotBeReadIsRefused) {
  const fs::path missing = folder_ / "missing.toml";
  EXPECT_EQ(test::refusal([&] { read_user_problem(missing); }),
            "cannot read '" + missing.string() + "'");
  EXPECT_EQ(test::refusal([&] { read_user_problem(folder_); }),
            "cannot read '" + folder_.string() + "'");
}

struct Mistake {
  const char* name;
  const char* from;
  const char* to;
  int line;
  const char* sentence;
};

class UserProblemRefuses : public UserProblem, public testing::WithParamInterface<Mistake> {};

TEST_P(UserProblemRefuses, WithFileAndLine) {
  const Mistake& mistake = GetParam();
  const fs::path file = write(edited(mistake.from, mistake.to));
  EXPECT_EQ(test::refusal([&] { read_user_problem(file); }),
            file.string() + ":" + std::to_string(mistake.line) + ": " + mistake.sentence);
}

const Mistake kMistakes[] = {
    {"AMisspeltKey", "friction = 0.5", "frction = 0.5", 8, "[[obstacle]] lacks 'friction'"},
    {"AnUnknownKey", "friction = 0.5", "friction = 0.5\ncolour = 3", 12,
     "[[obstacle]] has no key 'colour'; there are: name, point, friction, slope_deg, slope_tan, "
     "azimuth_deg, "
     "normal, motion"},
    {"AnUnknownTable", "[engine]", "[motor]", 5,
     "the file has no key 'motor'; there are: title, duration, gravity, friction, restitution, "
     "initial_overlap, drag, engine, obstacle, body, load, spring, pair, check, series, threshold, "
     "sweep"},
    {"ATextAsNumber", "mass = 2.0", "mass = \"2.0\"", 16,
     "'mass' must be a finite number, or a text of one and its unit: kg, g, mg, t"},
    {"ANegativeMass", "mass = 2.0", "mass = -2.0", 16, "'mass' must be positive"},
    {"ZeroMass", "mass = 2.0", "mass = 0", 16, "'mass' must be positive"},
    {"ANegativeStiffness", "mass = 2.0", "mass = 2.0\nyoungs_modulus = -1", 17,
     "'youngs_modulus' must be positive"},
    {"AnIncompressibleBody", "mass = 2.0", "mass = 2.0\npoisson_ratio = 0.5", 17,
     "'poisson_ratio' must lie between -1 and 0.5"},
    {"NegativeDamping", "mass = 2.0", "mass = 2.0\ndamping_time = -1e-3", 17,
     "'damping_time' must not be negative"},
    {"NaN", "friction = 0.5", "friction = nan", 11,
     "'friction' must be a finite number, or a text of one and its unit: 1, %"},
    {"ANegativeDuration", "duration = 0.1", "duration = -1", 2, "'duration' must be positive"},
    {"ZeroDuration", "duration = 0.1", "duration = 0", 2, "'duration' must be positive"},
    {"GravityOfTwoNumbers", "[0, 0, -10]", "[0, -10]", 3,
     "'gravity' must be three numbers, like [0, 0, 1]"},
    {"DragThatEndsBeforeItFades", "duration = 0.1",
     "duration = 0.1\ndrag = { rate = 9, full_until = 1, ends = 1 }", 3,
     "'ends' must follow 'full_until'"},
    {"GravityWithoutAsManyTimes", "[0, 0, -10]", "{ time = [0], acceleration = [] }", 3,
     "'time' and 'acceleration' must have as many entries, at least one"},
    {"KeyframesOutOfOrder", "[0, 0, -10]",
     "{ time = [1, 0], acceleration = [[0, 0, 0], [0, 0, -10]] }", 3, "the times must increase"},
    {"AnUnknownShape", "shape = \"point\"", "shape = \"disc\"", 15,
     "there is no shape 'disc'; there are: box, ball, mesh, surface, point"},
    {"ABoxWithoutSize", "shape = \"point\"", "shape = \"box\"", 13, "[[body]] lacks 'size'"},
    {"AnUnknownSupport", "rests_on = \"ramp\"", "rests_on = \"floor\"", 17,
     "there is no obstacle 'floor', nor a body of that name above; obstacles: ramp; bodies: none"},
    {"ABodyNowhere", "rests_on = \"ramp\"", "", 13, "[[body]] lacks 'position'"},
    {"AZeroNormal", "slope_deg = 20", "normal = [0, 0, 0]", 10, "'normal' must not be zero"},
    {"NormalAndSlope", "slope_deg = 20", "slope_deg = 20\nnormal = [0, 0, 1]", 10,
     "give 'normal' or 'slope_deg', not both"},
    {"NormalAndTangent", "slope_deg = 20", "slope_tan = 0.3\nnormal = [0, 0, 1]", 10,
     "give 'normal' or 'slope_tan', not both"},
    {"SlopeAndTangent", "slope_deg = 20", "slope_deg = 20\nslope_tan = 0.3", 11,
     "give 'slope_deg' or 'slope_tan', not both"},
    {"NegativeFriction", "friction = 0.5", "friction = -0.5", 11,
     "'friction' must not be negative"},
    {"NegativeFrictionOfBodies", "duration = 0.1", "duration = 0.1\nfriction = -1", 3,
     "'friction' must not be negative"},
    {"ARotationOfOneNumber", "rests_on = \"ramp\"", "position = [0, 0, 0]\nrotation = 30", 18,
     "'rotation' must be like { axis = [0, 0, 1], angle_deg = 30 }"},
    {"AnUnknownObservable", "\"speed\"", "\"sped\"", 20,
     "there is no observable 'sped'; there are: position, velocity, speed, displacement, drift, "
     "mean-velocity, acceleration, rotation, angular-velocity, kinetic-energy, total-energy, "
     "normal-force, friction-force, slip, penetration, contacts"},
    {"AMissingReason", "reason = \"it sticks\"", "", 19, "[[check]] lacks 'reason'"},
    {"AMissingDirection", "\"speed\"", "\"velocity\"", 19, "[[check]] lacks 'direction'"},
    {"AnUnknownDirection", "\"speed\"", "\"velocity\"\ndirection = \"up\"", 21,
     "'direction' is three numbers, \"downhill\" or { downhill = \"OBSTACLE\" }"},
    {"AnUnknownBody", "\"speed\"", "\"speed\"\nbody = \"box\"", 21,
     "there is no body 'box'; there are: point"},
    {"ATimeAfterTheEnd", "\"speed\"", "\"speed\"\nat = 0.2", 21,
     "the times of a check must follow 0 ≤ from < at ≤ 0.1 s"},
    {"AWindowBackwards", "\"speed\"", "\"drift\"\nfrom = 0.09\nat = 0.05", 22,
     "the times of a check must follow 0 ≤ from < at ≤ 0.1 s"},
    {"ANegativeTolerance", "tolerance = 1e-12", "tolerance = -1", 22,
     "'tolerance' must not be negative"},
    {"RelativeToZero", "tolerance = 1e-12", "tolerance = 1e-12\nrelative = true", 23,
     "an error relative to an expected value of 0 has no meaning without a 'scale'"},
};

INSTANTIATE_TEST_SUITE_P(Mistakes, UserProblemRefuses, testing::ValuesIn(kMistakes),
                         [](const auto& one) { return std::string(one.param.name); });

TEST_F(UserProblem, ThatIsNoTomlNamesTheLine) {
  const fs::path file = write(edited("mass = 2.0", "mass = 2.0 kg"));
  EXPECT_THAT(test::refusal([&] { read_user_problem(file); }), HasSubstr(file.string() + ":16: "));
  const fs::path twice = write(edited("mass = 2.0", "mass = 2.0\nmass = 3.0"));
  EXPECT_THAT(test::refusal([&] { read_user_problem(twice); }),
              HasSubstr(twice.string() + ":17: "));
}

TEST_F(UserProblem, WithoutBodiesOrChecksIsRefused) {
  const std::string file = write("duration = 1\n").string();
  EXPECT_THAT(test::refusal([&] { read_user_problem(file); }),
              AllOf(HasSubstr(file + ":"), HasSubstr("the file describes no [[body]]")));
  std::string text = kProblem;
  text.erase(text.find("[[check]]"));
  EXPECT_THAT(test::refusal([&] { read_user_problem(write(text)); }),
              HasSubstr("the file has no [[check]], so nothing could fail"));
}

// What the file's grammar allows but no scene can be made of: the record says so.
struct BadScene {
  const char* name;
  const char* from;
  const char* to;
  const char* sentence;
};

class UserSceneRefused : public UserProblem, public testing::WithParamInterface<BadScene> {};

TEST_P(UserSceneRefused, AsTheRecordsError) {
  const Record record = run(read_user_problem(write(edited(GetParam().from, GetParam().to))));
  EXPECT_EQ(record.verdict, Verdict::kError);
  EXPECT_THAT(record.error, HasSubstr(GetParam().sentence));
}

constexpr const char* kBox =
    "shape = \"box\"\nsize = [0.2, 0.2, 0.1]\nmass = 1.0\nposition = [0, 0, 1]";

const BadScene kBadScenes[] = {
    {"TooLongAStep", "shape = \"point\"\nmass = 2.0\nrests_on = \"ramp\"", kBox,
     "the time step 0.001 s is above the stability limit"},
    {"NegativeStep", "dt = 1e-3", "dt = -1e-3", "the time step must be positive and finite"},
    {"UnknownRule", "dt = 1e-3", "rule = \"magic\"", "unknown friction rule 'magic'"},
};

INSTANTIATE_TEST_SUITE_P(Scenes, UserSceneRefused, testing::ValuesIn(kBadScenes),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace stiction
