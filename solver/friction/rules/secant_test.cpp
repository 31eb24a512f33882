// SPDX-License-Identifier: BSD-3-Clause
#include "solver/friction/rules/secant.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/testing/test_scenes.h"
#include "solver/testing/test_slips.h"

namespace stiction {
namespace {

using test::kInverseMass;

// A contact whose friction comes out too weak by a factor: u = ũ (1 − ξ (1 − ε)).
double slip_after(const Secant& rule, double artefact, int steps) {
  double memory[3];
  rule.reset(memory);
  const Vec3 free_slip(0.02, 0.0, 0.0);
  Vec3 slip = Vec3::Zero();
  ContactStatus was = ContactStatus::kNew;
  for (int k = 0; k < steps; ++k) {
    const SlipSolution solution = rule.solve({.free_slip = free_slip,
                                              .start_slip = slip,
                                              .inverse_mass = kInverseMass,
                                              .bound = 1e9,
                                              .was = was},
                                             memory);
    was = solution.status;
    slip = free_slip + (1.0 - artefact) * kInverseMass * solution.force;
  }
  return slip.norm();
}

TEST(SecantRule, SolvesALinearArtefactInThreeSteps) {
  // The fourth update has two slips to draw a line through; what is left is round-off of ũ.
  EXPECT_LT(slip_after(Secant({}), 0.3, 4), 1e-16);
  EXPECT_GT(slip_after(Secant({}), 0.3, 1), 1e-3);
}

TEST(SecantRule, StaysAtRestOnceThereWithItsSafeguard) {
  EXPECT_LT(slip_after(Secant({}), 0.3, 50), 1e-16);
}

TEST(SecantRule, ForgetsOnSlipUnlessToldToKeep) {
  for (const bool keep : {false, true}) {
    const RuleSettings given{{"memory", keep ? 1.0 : 0.0}};
    double memory[3] = {1.5, 1.25, 0.1};
    const SlipSolution solution = Secant(given).solve({.free_slip = Vec3(1, 0, 0),
                                                       .start_slip = Vec3::Zero(),
                                                       .inverse_mass = kInverseMass,
                                                       .bound = 1.0,
                                                       .was = ContactStatus::kSlip},
                                                      memory);
    EXPECT_EQ(solution.status, ContactStatus::kSlip);
    EXPECT_EQ(solution.force, Vec3(-1, 0, 0));
    EXPECT_EQ(memory[0], keep ? 1.5 : 1.0);
  }
}

// Slip that grows with friction has the wrong slope: the formula would push ξ away from the root.
TEST(SecantRule, TakesTheFixedPointStepWhereTheSlopeHasTheWrongSign) {
  double memory[3] = {1.2, 1.0, 0.1};
  Secant({}).solve({.free_slip = Vec3(1, 0, 0),
                    .start_slip = Vec3(0.2, 0, 0),
                    .inverse_mass = kInverseMass,
                    .bound = 1e9,
                    .was = ContactStatus::kStick},
                   memory);
  EXPECT_DOUBLE_EQ(memory[0], 1.2 + parameter::kGain.initial * 0.2);
}

}  // namespace
}  // namespace stiction
