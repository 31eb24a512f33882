// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/slopes/incline_problem.h"

#include <gtest/gtest.h>

#include <cmath>

#include "validation/protocols/incline_run.h"

namespace stiction {
namespace {

constexpr double kRoundOff = 4e-16;  // of unit vectors: two roundings a component

class InclineAtAzimuth : public testing::TestWithParam<int> {
 protected:
  InclineAtAzimuth() {
    setup.tan_slope = 0.75;  // sin θ = 0.6, cos θ = 0.8
    setup.azimuth = radians(GetParam());
    setup.yaw = radians(20.0);
  }
  InclineSetup setup;
};

TEST_P(InclineAtAzimuth, HasAnOrthonormalFrameThatFallsTowardsIt) {
  const InclineFrame frame = incline_frame(setup);
  EXPECT_NEAR(frame.normal.norm(), 1.0, kRoundOff);
  EXPECT_NEAR(frame.downhill.norm(), 1.0, kRoundOff);
  EXPECT_NEAR(frame.normal.dot(frame.downhill), 0.0, kRoundOff);
  EXPECT_NEAR(frame.normal.z(), 0.8, kRoundOff);
  EXPECT_NEAR(frame.downhill.z(), -0.6, kRoundOff);
  const Vec3 level(std::cos(setup.azimuth), std::sin(setup.azimuth), 0.0);
  EXPECT_NEAR(frame.downhill.dot(level), 0.8, kRoundOff);
}

TEST_P(InclineAtAzimuth, RestsTheBoxExactlyOnThePlane) {
  const Problem problem = incline_problem(setup);
  const ProblemBody& body = problem.bodies[0];
  const Vec3 size = std::get<BoxShape>(body.shape).size;
  int on_plane = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 sign((corner & 1) ? 0.5 : -0.5, (corner & 2) ? 0.5 : -0.5,
                    (corner & 4) ? 0.5 : -0.5);
    const Vec3 x = body.position + body.rotation * Vec3(sign.array() * size.array());
    const double gap = problem.obstacles[0].normal.dot(x - problem.obstacles[0].point);
    if (sign.z() < 0.0) {
      EXPECT_NEAR(gap, 0.0, 0.1 * kRoundOff);  // of coordinates of 0.1 m
      ++on_plane;
    } else {
      EXPECT_NEAR(gap, size.z(), 0.2 * kRoundOff);
    }
  }
  EXPECT_EQ(on_plane, 4);
}

TEST_P(InclineAtAzimuth, TurnsTheBoxAboutTheNormal) {
  InclineSetup straight = setup;
  straight.yaw = 0.0;
  const Eigen::Quaterniond turn = incline_problem(setup).bodies[0].rotation *
                                  incline_problem(straight).bodies[0].rotation.inverse();
  const Eigen::AngleAxisd angle(turn);
  EXPECT_NEAR(angle.angle(), radians(20.0), 1e-15);
  EXPECT_NEAR(angle.axis().dot(incline_frame(setup).normal), 1.0, 1e-14);
}

TEST_P(InclineAtAzimuth, LoadsFirstIntoThePlaneAndThenAlongIt) {
  const Problem problem = settled_incline_problem(setup);
  const InclineFrame frame = incline_frame(setup);
  const SettledLoad load;
  const double g = kStandardGravity;
  const auto into = [&](double t) { return -frame.normal.dot(problem.gravity.at(t)); };
  const auto along = [&](double t) { return frame.downhill.dot(problem.gravity.at(t)); };
  EXPECT_EQ(problem.gravity.at(0.0), Vec3::Zero());
  for (const double t : {0.05, 0.1, load.normal_full, 0.25, load.tangential_from}) {
    EXPECT_NEAR(along(t), 0.0, g * kRoundOff) << "no shear at " << t;
  }
  EXPECT_NEAR(into(0.1), 0.5 * 0.8 * g, g * 4 * kRoundOff);
  for (const double t : {load.normal_full, 0.5, load.tangential_full, 5.0}) {
    EXPECT_NEAR(into(t), 0.8 * g, g * 4 * kRoundOff) << "the whole weight at " << t;
  }
  EXPECT_NEAR(along(0.5), 0.5 * 0.6 * g, g * 4 * kRoundOff);
  EXPECT_EQ(problem.gravity.at(load.tangential_full), Vec3(0, 0, -g));
}

INSTANTIATE_TEST_SUITE_P(Azimuths, InclineAtAzimuth, testing::Values(0, 30, 45, 200),
                         [](const auto& one) { return std::to_string(one.param) + "Degrees"; });

TEST(InclineProblem, HasConstantGravityFrictionAndASpeedDownhill) {
  InclineSetup setup;
  setup.tan_slope = 0.75;
  setup.azimuth = radians(30.0);
  setup.friction = 0.4;
  setup.speed = 2.0;
  setup.duration = 3.0;
  const Problem problem = incline_problem(setup);
  EXPECT_EQ(problem.gravity.at(0.0), Vec3(0, 0, -kStandardGravity));
  EXPECT_EQ(problem.gravity.at(9.0), Vec3(0, 0, -kStandardGravity));
  EXPECT_EQ(problem.obstacles[0].friction, 0.4);
  EXPECT_EQ(problem.duration, 3.0);
  EXPECT_NEAR(problem.bodies[0].velocity.dot(incline_frame(setup).downhill), 2.0, 4 * kRoundOff);
}

TEST(InclineProblem, PutsAPointOnThePlaneItself) {
  InclineSetup setup;
  setup.shape = PointShape{};
  setup.tan_slope = 0.75;
  EXPECT_EQ(incline_problem(setup).bodies[0].position, Vec3::Zero());
}

}  // namespace
}  // namespace stiction
