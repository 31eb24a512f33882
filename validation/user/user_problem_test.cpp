// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/user/user_problem.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "reference/meshes/box_mesh.h"
#include "reference/meshes/filled_surface.h"
#include "solver/testing/test_refusal.h"
#include "validation/core/runner.h"

namespace stiction {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Each;
using testing::Field;
using testing::HasSubstr;

// A small problem without a mistake; the line numbers below are of this text.
constexpr const char* kProblem = R"(title = "a point on a ramp"
duration = 0.1
gravity = [0, 0, -10]

[engine]
dt = 1e-3

[[obstacle]]
name = "ramp"
slope_deg = 20
friction = 0.5

[[body]]
name = "point"
shape = "point"
mass = 2.0
rests_on = "ramp"

[[check]]
observable = "speed"
expected = 0.0
tolerance = 1e-12
reason = "it sticks"
)";

class UserProblem : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "user_problem_XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& text) {
    const fs::path file = folder_ / "ramp.toml";
    std::ofstream(file) << text;
    return file;
  }

  // The problem with `from` replaced by `to`.
  static std::string edited(const std::string& from, const std::string& to) {
    std::string text = kProblem;
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("the problem has no '" + from + "'");
    return text.replace(at, from.size(), to);
  }

  static Record run(const Case& one) {
    return run_job({one, find_engine("stiction"), one.variants.front()}, 1.0);
  }

  fs::path folder_;
};

TEST_F(UserProblem, BecomesACaseNamedAfterItsFile) {
  const Case one = read_user_problem(write(kProblem));
  EXPECT_EQ(one.name, "user/ramp");
  EXPECT_EQ(one.title, "a point on a ramp");
  EXPECT_EQ(one.variants, std::vector<Settings>{(Settings{{"dt", "0.001"}})});
}

TEST_F(UserProblem, RunsLikeABuiltInCase) {
  const Record record = run(read_user_problem(write(kProblem)));
  EXPECT_EQ(record.error, "");
  EXPECT_EQ(record.verdict, Verdict::kPass);
  ASSERT_EQ(record.checks.size(), 1u);
  EXPECT_EQ(record.checks[0].claim.reason, "it sticks");
  EXPECT_EQ(record.checks[0].claim.unit, "m/s");
  EXPECT_EQ(record.checks[0].claim.kind, ReferenceKind::kExternal);
  EXPECT_EQ(record.series.size(), 2u);
  EXPECT_EQ(record.cost.steps, 100u);
}

TEST_F(UserProblem, FailsWhenItsExpectationIsWrong) {
  EXPECT_EQ(run(read_user_problem(write(edited("expected = 0.0", "expected = 0.1")))).verdict,
            Verdict::kFail);
}

TEST_F(UserProblem, MeasuresWhatWasAskedAtTheTimesAskedFor) {
  // Free fall from rest at 10 m/s²: v(0.05) = −0.5, mean acceleration −10; the second body stands.
  const std::string text = R"(duration = 0.1
gravity = [0, 0, -10]
[engine]
dt = 1e-3
[[obstacle]]
name = "floor"
friction = 0.0
[[body]]
name = "falling"
shape = "point"
mass = 1.0
position = [0, 0, 5]
[[body]]
name = "standing"
shape = "point"
mass = 3.0
rests_on = "floor"
[[check]]
observable = "velocity"
direction = [0, 0, 2]
at = 0.05
expected = -0.5
tolerance = 1e-13
reason = "round-off; a direction is made a unit vector"
[[check]]
observable = "acceleration"
direction = [0, 0, 1]
from = 0.02
at = 0.06
expected = -10
tolerance = 1e-11
reason = "round-off of a difference over 0.04 s"
[[check]]
observable = "normal-force"
body = "standing"
expected = 30
tolerance = 1e-6
reason = "round-off of gΔt² = 1e-5 m"
)";
  const Record record = run(read_user_problem(write(text)));
  EXPECT_EQ(record.error, "");
  ASSERT_EQ(record.checks.size(), 3u);
  EXPECT_THAT(record.checks, Each(Field(&Judgement::verdict, Verdict::kPass)));
}

TEST_F(UserProblem, WithGravityThatGrowsReadsItsKeyframes) {
  const Case one = read_user_problem(
      write(edited("gravity = [0, 0, -10]",
                   "gravity = { time = [0, 0.05], acceleration = [[0, 0, 0], [0, 0, -10]] }")));
  EXPECT_EQ(run(one).verdict, Verdict::kPass);
}

TEST_F(UserProblem, ExampleOfTheRepositoryPasses) {
  const fs::path example = fs::path(__FILE__).parent_path() / "examples" / "ramp.toml";
  const Record record = run(read_user_problem(example));
  EXPECT_EQ(record.error, "");
  EXPECT_EQ(record.verdict, Verdict::kPass);
  EXPECT_THAT(record.checks, Each(Field(&Judgement::verdict, Verdict::kPass)));
}

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
     "[[obstacle]] has no key 'colour'; there are: azimuth_deg, friction, name, normal, point, "
     "slope_deg"},
    {"AnUnknownTable", "[engine]", "[motor]", 5,
     "the file has no key 'motor'; there are: body, check, drag, duration, engine, friction, "
     "gravity, "
     "obstacle, "
     "title"},
    {"ATextAsNumber", "mass = 2.0", "mass = \"2.0\"", 16, "'mass' must be a finite number"},
    {"NaN", "friction = 0.5", "friction = nan", 11, "'friction' must be a finite number"},
    {"ANegativeDuration", "duration = 0.1", "duration = -1", 2, "'duration' must be positive"},
    {"ZeroDuration", "duration = 0.1", "duration = 0", 2, "'duration' must be positive"},
    {"GravityOfTwoNumbers", "[0, 0, -10]", "[0, -10]", 3,
     "'gravity' must be three numbers, like [0, 0, 1]"},
    {"DragThatEndsBeforeItFades", "duration = 0.1",
     "duration = 0.1\ndrag = { rate = 9, full_until = 1, ends = 1 }", 3,
     "'ends' must follow 'full_until'"},
    {"GravityWithoutAsManyTimes", "[0, 0, -10]", "{ time = [0], acceleration = [] }", 3,
     "gravity needs as many times as accelerations, at least one"},
    {"AnUnknownShape", "shape = \"point\"", "shape = \"disc\"", 15,
     "there is no shape 'disc'; there are: box, ball, mesh, surface, point"},
    {"ABoxWithoutSize", "shape = \"point\"", "shape = \"box\"", 13, "[[body]] lacks 'size'"},
    {"AnUnknownSupport", "rests_on = \"ramp\"", "rests_on = \"floor\"", 17,
     "there is no rests_on 'floor'; there are: ramp"},
    {"ABodyNowhere", "rests_on = \"ramp\"", "", 13, "[[body]] lacks 'position'"},
    {"AZeroNormal", "slope_deg = 20", "normal = [0, 0, 0]", 10, "'normal' must not be zero"},
    {"NormalAndSlope", "slope_deg = 20", "slope_deg = 20\nnormal = [0, 0, 1]", 10,
     "give 'normal' or 'slope_deg', not both"},
    {"ARotationOfOneNumber", "rests_on = \"ramp\"", "position = [0, 0, 0]\nrotation = 30", 18,
     "'rotation' must be like { axis = [0, 0, 1], angle_deg = 30 }"},
    {"AnUnknownObservable", "\"speed\"", "\"sped\"", 20,
     "there is no observable 'sped'; there are: position, velocity, speed, displacement, drift, "
     "mean-velocity, acceleration, kinetic-energy, total-energy, normal-force, friction-force, "
     "slip, penetration, contacts"},
    {"AMissingReason", "reason = \"it sticks\"", "", 19, "[[check]] lacks 'reason'"},
    {"AMissingDirection", "\"speed\"", "\"velocity\"", 19, "[[check]] lacks 'direction'"},
    {"AnUnknownDirection", "\"speed\"", "\"velocity\"\ndirection = \"up\"", 21,
     "'direction' is three numbers or, with an obstacle, \"downhill\""},
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

// A body from a surface file beside the problem's own. The mesher is a script here; the true one
// fills a cube in validate_test.sh.
class ClosedSurfaceInUserProblem : public UserProblem {
 protected:
  void SetUp() override {
    UserProblem::SetUp();
    setenv("STICTION_MESHER", (folder_ / "mesher").c_str(), 1);
  }
  void TearDown() override {
    unsetenv("STICTION_MESHER");
    UserProblem::TearDown();
  }
  void mesher_does(const std::string& lines) {
    std::ofstream(folder_ / "mesher") << "#!/bin/sh\n" << lines << '\n';
    fs::permissions(folder_ / "mesher", fs::perms::owner_all);
  }
  static std::string problem() {
    return edited("shape = \"point\"",
                  "shape = \"surface\"\nfile = \"cube.off\"\nscale = 1e-3\ncell_size = 0.2");
  }
};

TEST_F(ClosedSurfaceInUserProblem, BecomesABody) {
  // A cube of 200 mm with the origin in its middle.
  std::ofstream(folder_ / "answer")
      << reference::to_text({12, 8e6, reference::box_mesh({200.0, 200.0, 200.0}, {2, 2, 2})});
  mesher_does("[ \"$2\" = 200 ] && cat '" + (folder_ / "answer").string() + "'");
  std::string text = problem();
  text.replace(text.find("\"speed\""), 7, "\"position\"\ndirection = [0, 0, 1]\nat = 1e-3");
  text.replace(text.find("dt = 1e-3"), 9, "dt = 1e-4");
  const Record record = run(read_user_problem(write(text)));
  ASSERT_EQ(record.meshes.size(), 1u) << record.error;
  EXPECT_EQ(record.meshes[0].tetrahedra, 40u);
  // The cube's middle is 0.1 m above the ramp, along its normal; in 1 ms it falls 5 µm at most.
  EXPECT_NEAR(record.checks.at(0).value, 0.1 * std::cos(std::atan(1.0) * 4.0 / 9.0), 1e-5);
}

TEST_F(ClosedSurfaceInUserProblem, IsRefusedWithTheReasonAndTheLine) {
  mesher_does(
      "echo cube.off: it is not closed >&2; exit " +
      std::to_string(reference::kFirstFlaw + static_cast<int>(reference::SurfaceFlaw::not_closed)));
  const std::string file = write(problem()).string();
  EXPECT_THAT(test::refusal([&] { read_user_problem(file); }),
              testing::StrEq(file + ":16: cube.off: it is not closed"));
}

// The mesher's failure is no mistake in the file: the problems beside this one still run.
TEST_F(ClosedSurfaceInUserProblem, WhoseMesherFailsIsARecordsError) {
  mesher_does("kill -SEGV $$");
  const fs::path file = write(problem());
  const Record record = run(read_user_problem(file));
  EXPECT_EQ(record.verdict, Verdict::kError);
  EXPECT_EQ(record.error, file.string() + ":16: " + (folder_ / "cube.off").string() +
                              ": the mesher ended with signal 11 (Segmentation fault)");
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
    {"NegativeMass", "mass = 2.0", "mass = -2.0",
     "body 'point': mass must be positive and finite, not -2 kg"},
    {"ZeroMass", "mass = 2.0", "mass = 0", "body 'point': mass must be positive and finite"},
    {"NegativeFriction", "friction = 0.5", "friction = -0.5",
     "obstacle 'ramp': the friction coefficient must be non-negative and finite, not -0.5"},
    {"InsideTheObstacle", "rests_on = \"ramp\"", "position = [0, 0, -1]",
     "m inside obstacle 'ramp'"},
    {"TooLongAStep", "shape = \"point\"\nmass = 2.0\nrests_on = \"ramp\"", kBox,
     "the time step 0.001 s is above the stability limit"},
    {"NegativeStep", "dt = 1e-3", "dt = -1e-3", "the time step must be positive and finite"},
    {"UnknownRule", "dt = 1e-3", "rule = \"magic\"", "unknown friction rule 'magic'"},
    {"KeyframesOutOfOrder", "[0, 0, -10]",
     "{ time = [1, 0], acceleration = [[0, 0, 0], [0, 0, -10]] }",
     "gravity: keyframe 1 at 0 s does not follow 1 s"},
};

INSTANTIATE_TEST_SUITE_P(Scenes, UserSceneRefused, testing::ValuesIn(kBadScenes),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace stiction
