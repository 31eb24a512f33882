// SPDX-License-Identifier: GPL-3.0-or-later
// The scenes that a person tries first are what their headers say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/mesh/mesh.h"
#include "validation/problems/piles/crossed_bars_problem.h"
#include "validation/problems/piles/stack_problem.h"
#include "validation/problems/sheet_problem.h"
#include "validation/problems/slopes/slab_poses.h"

namespace stiction {
namespace {

TEST(Stack, SlidesAtMuOrTopplesAtOneOverItsHeight) {
  for (const int boxes : {1, 2, 3, 5, 10}) {
    StackSetup setup;
    setup.boxes = boxes;
    EXPECT_NEAR(critical_tan(setup).rigid, std::min(0.5, 1.0 / boxes), 1e-5) << boxes;
    EXPECT_LE(critical_tan(setup).elastic, critical_tan(setup).rigid);
  }
}

TEST(Stack, IsFlush) {
  StackSetup setup;
  setup.boxes = 3;
  setup.ground = Ground::kFlush;
  const Problem problem = stack_problem(setup);
  ASSERT_EQ(problem.bodies.size(), 4u);
  for (std::size_t b = 0; b < 4; ++b) {
    const TetMesh& mesh = std::get<MeshShape>(problem.bodies[b].shape).mesh;
    EXPECT_EQ(mesh.vertices.row(0).maxCoeff(), 0.05);
    EXPECT_EQ(mesh.vertices.row(1).minCoeff(), -0.05);
  }
  EXPECT_EQ(problem.bodies[3].position.z() + 0.05, problem.bodies[0].position.z() - 0.05);
}

TEST(CrossedBars, AreSixteenWithoutAVertexOverTheOtherBar) {
  EXPECT_EQ(crossed_bars().size(), 16u);
  for (const CrossedBarsSetup& setup : crossed_bars()) {
    EXPECT_GT(clearance(setup), 1e-3) << crossed_bars_words(setup);
  }
}

// The crossing is a parallelogram about the point where the middle lines meet; the upper bar's
// centre of mass is `along_upper` from there along that bar.
TEST(CrossedBars, HaveTheirCentreOfMassOverTheCrossing) {
  for (const CrossedBarsSetup& setup : crossed_bars()) {
    const Vec3 centre = crossed_bars_problem(setup).bodies[0].position;
    EXPECT_LT(std::abs(centre.y()), 0.5 * setup.size.y()) << crossed_bars_words(setup);
  }
}

TEST(PosedSlabs, AreOfEachKindAndBelowTheirLimit) {
  const std::vector<PosedSlab> all = posed_slabs(200, 8);
  std::vector<int> count(kPoses);
  for (const PosedSlab& posed : all) {
    ++count[static_cast<std::size_t>(posed.pose)];
    EXPECT_LE(std::tan(posed.setup.slope), 0.4878) << pose_words(posed);
    if (posed.pose == SlabPose::kAnywhere) continue;
    EXPECT_LE(std::tan(posed.setup.slope), 0.8 * critical_tan(posed.setup)) << pose_words(posed);
  }
  for (const int each : count) EXPECT_EQ(each, 40);
}

// By hand: a box that hangs out by 40 % topples where the line of action of its weight leaves the
// slab's edge, 0.1 of its length from its centre: tan θ = 0.1 a / (c/2).
TEST(PosedSlabs, HangingTopplesWhereTheWeightLeavesTheEdge) {
  SlabSetup setup;
  setup.box_size = Vec3(0.1, 0.1, 0.1);
  setup.offset = Vec3(0.5 * kSlabWidth - 0.01, 0.0, 0.0);
  EXPECT_NEAR(critical_tan(setup), 0.2, 1e-5);
  setup.azimuth = std::numbers::pi;
  EXPECT_NEAR(critical_tan(setup), 0.5, 1e-5) << "uphill it slides first";
}

TEST(Sheet, IsADrumOfTheGivenThickness) {
  SheetSetup setup;
  setup.thickness = 2e-3;
  const Problem problem = sheet_problem(setup);
  const TetMesh& mesh = std::get<MeshShape>(problem.bodies[1].shape).mesh;
  double volume = 0.0;
  for (Eigen::Index e = 0; e < mesh.tetrahedra.cols(); ++e) {
    const double part = signed_volume(mesh, e);
    EXPECT_GT(part, 0.0);
    volume += part;
  }
  EXPECT_NEAR(1000.0 * volume, problem.bodies[1].mass, 1e-9);
  EXPECT_EQ(mesh.vertices.row(2).maxCoeff(), 2e-3);
}

TEST(Sheet, HasTheCubeAGapAboveIt) {
  for (const Stance stance : {Stance::kFace, Stance::kEdge, Stance::kCorner}) {
    SheetSetup setup;
    setup.stance = stance;
    const ProblemBody cube = sheet_problem(setup).bodies[0];
    const Eigen::Matrix3Xd vertices =
        (cube.rotation.toRotationMatrix() * std::get<MeshShape>(cube.shape).mesh.vertices)
            .colwise() +
        cube.position;
    EXPECT_NEAR(vertices.row(2).minCoeff(), setup.thickness + setup.gap, 1e-12);
  }
}

}  // namespace
}  // namespace stiction
