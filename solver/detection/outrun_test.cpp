// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/outrun.h"

#include <gtest/gtest.h>

#include "solver/step.h"
#include "solver/testing/test_pairs.h"

namespace stiction {
namespace {

// A cube of two cells that flies at `speed` (m/s) along x towards another, 0.5 m away.
PairSearch::Outrun after_a_step(double speed, double aside = 0.0) {
  SceneDescription description;
  description.bodies = {test::elastic_body(test::cube_mesh(2)),
                        test::elastic_body(test::cube_mesh(2))};
  description.bodies[1].mesh.vertices.colwise() += Vec3(-1.5, aside, 0.1);
  description.bodies[1].initial_velocity =
      Vec3(speed, 0.0, 0.0).replicate(1, description.bodies[1].mesh.vertices.cols());
  const Scene scene = build_scene(description);
  State state = initial_state(scene);
  Workspace workspace;
  step(scene, {.time_step = 1e-3}, state, workspace);
  return workspace.search.outrun;
}

TEST(Outrun, IsNotedWhereAStepLeapsOverAnElement) {
  const PairSearch::Outrun outrun = after_a_step(2000.0);  // 2 m in a step, past the other cube
  EXPECT_NEAR(outrun.travel, 2.0, 1e-12);
  EXPECT_EQ(outrun.body + outrun.other, 1);
  EXPECT_GT(outrun.width, 0.1);
  EXPECT_LT(outrun.width, 0.5);
}

TEST(Outrun, IsNotNotedBelowThatOrWhereBodiesMiss) {
  EXPECT_EQ(after_a_step(100.0).travel, 0.0) << "0.1 m in a step";
  EXPECT_EQ(after_a_step(2000.0, 3.0).travel, 0.0) << "3 m aside";
}

}  // namespace
}  // namespace stiction
