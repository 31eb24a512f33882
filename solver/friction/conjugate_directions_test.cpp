// SPDX-License-Identifier: BSD-3-Clause
#include "solver/friction/conjugate_directions.h"

#include <gtest/gtest.h>

#include "solver/friction/friction.h"
#include "solver/response/pair_normal_force.h"
#include "solver/testing/test_pairs.h"

namespace stiction {
namespace {

// A cube that is pushed over another: contacts of both sides, which say nearly the same twice.
class PushedCubes : public testing::Test {
 protected:
  struct Solved {
    double fastest = 0.0;  // slip left, m/s
    std::uint64_t sweeps = 0;
    Vec3 momentum = Vec3::Zero();
  };

  static Solved solve(const std::string& rule, int sweeps, double tolerance,
                      double friction = 1e3) {  // nothing slides
    SceneDescription description = test::stacked_cubes(0.05);
    description.friction = friction;
    description.gravity = {{0.0}, {Vec3(0.0, 0.0, -9.81)}};  // the scale of the tolerance
    const Scene scene = build_scene(description);
    Options options;
    options.rule = rule;
    options.sweeps = sweeps;
    if (rule == "conjugate-vector") options.friction["slip-tolerance"] = tolerance;
    test::Found found(scene, options, initial_state(scene));
    pair_normal_forces(scene, options, found.workspace);
    const Body& upper = scene.bodies[1];
    for (int v = 0; v < upper.vertex_count; ++v) {
      found.workspace.velocity[static_cast<std::size_t>(upper.first_vertex + v)].v +=
          Vec3(0.1, 0.02 * v, 0.0);
    }
    Solved solved;
    solved.momentum = -test::momentum(scene, found.workspace.velocity);
    friction_forces(scene, options, found.state, found.workspace);
    solved.momentum += test::momentum(scene, found.workspace.velocity);
    solved.sweeps = found.workspace.sweeps;
    for (const PairContact& contact : found.workspace.pairs) {
      Vec3 slip = found.workspace.velocity[static_cast<std::size_t>(contact.vertex)].v;
      for (int k = 0; k < 4; ++k) {
        slip -= contact.weight[k] *
                found.workspace.velocity[static_cast<std::size_t>(contact.partner[k])].v;
      }
      slip -= contact.normal.dot(slip) * contact.normal;
      solved.fastest = std::max(solved.fastest, slip.norm());
    }
    return solved;
  }
};

TEST_F(PushedCubes, AreTheStoredVectorWithOneSweep) {
  EXPECT_EQ(solve("conjugate-vector", 1, 0.0).fastest, solve("stored-vector", 1, 0.0).fastest);
}

TEST_F(PushedCubes, LeaveATenthOfTheSlipInAsManySweeps) {
  const double plain = solve("stored-vector", 48, 0.0).fastest;
  EXPECT_GT(plain, 1e-9) << "or there is nothing to accelerate";
  EXPECT_LT(solve("conjugate-vector", 48, 0.0).fastest, 0.1 * plain);
}

TEST_F(PushedCubes, SweepUntilTheToleranceAndNoFurther) {
  const Solved solved = solve("conjugate-vector", 1000, 1e-6);
  EXPECT_LT(solved.sweeps, 500u);
  EXPECT_GT(solved.sweeps, 4u);
  // The last sweep changed no contact by more; what its neighbours then did to it is of that size.
  EXPECT_LT(solved.fastest, 1e-5);
  EXPECT_EQ(solve("conjugate-vector", 1000, 1e6).sweeps, 1u);
}

TEST_F(PushedCubes, GiveUpWhereSweepsHardlyHelp) {
  const Solved solved = solve("conjugate-vector", 1000, 0.0, 1e-4);
  EXPECT_GE(solved.sweeps, 8u);
  EXPECT_LE(solved.sweeps, 64u) << "all contacts slide, which more sweeps do not change";
}

TEST_F(PushedCubes, KeepTheirMomentum) {
  // Forces act in pairs: round-off of the bodies' 1 kg m/s.
  EXPECT_LT(solve("conjugate-vector", 20, 0.0).momentum.norm(), 1e-10);
}

}  // namespace
}  // namespace stiction
