// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/user/user_problem.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "reference/meshes/box_mesh.h"
#include "reference/meshes/filled_surface.h"
#include "solver/testing/test_refusal.h"
#include "validation/user/test_user_problem.h"
#include "validation/user/user_case.h"

namespace stiction {
namespace {

namespace fs = std::filesystem;
using test::kProblem;
using test::UserProblem;
using testing::Each;
using testing::Field;

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

TEST_F(UserProblem, ASlopeCanBeGivenByItsTangent) {
  const auto normal = [&](const std::string& slope) {
    std::istringstream text(edited("slope_deg = 20", slope));
    return user_problem(text, folder_ / "ramp.toml").problem.obstacles[0].normal;
  };
  EXPECT_LT((normal("slope_tan = 1") - normal("slope_deg = 45")).norm(), 1e-15);
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
body = "falling"
direction = [0, 0, 2]
at = 0.05
expected = -0.5
tolerance = 1e-13
reason = "round-off; a direction is made a unit vector"
[[check]]
observable = "acceleration"
body = "falling"
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

}  // namespace
}  // namespace stiction
