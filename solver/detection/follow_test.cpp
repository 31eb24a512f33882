// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/follow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "solver/testing/test_pairs.h"

namespace stiction {
namespace {

constexpr Real kStep = Real(0.01);  // s

// Two cubes whose lists have just been made.
struct Followed {
  Scene scene = build_scene(test::stacked_cubes(0.01));
  test::Found found{scene, {}, initial_state(scene)};

  PairSearch& search() { return found.workspace.search; }
  bool follow() {
    return stiction::follow(scene, kStep, found.state, found.workspace.velocity, nullptr, search());
  }
};

TEST(Follow, TellsWhereVerticesComeToAndHowFarBodiesHaveMoved) {
  Followed of;
  std::vector<Velocity>& velocity = of.found.workspace.velocity;
  const Eigen::Matrix3Xd random = test::noise(of.scene.vertex_count(), 1.0, 3);
  const Real most = Real(0.4) * of.search().skin / kStep;
  for (std::size_t k = 0; k < velocity.size(); ++k) {
    velocity[k].v = most * random.col(static_cast<Eigen::Index>(k)).cast<Real>();
  }
  const std::vector<Vec3> last = of.search().predicted;
  const std::vector<double> path = of.search().path;
  EXPECT_FALSE(of.follow());
  for (std::size_t b = 0; b < of.scene.bodies.size(); ++b) {
    const Body& body = of.scene.bodies[b];
    Real moved = 0, way = 0;
    for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v) {
      const auto k = static_cast<std::size_t>(v);
      const Vec3 x = of.found.state.position[k].x + kStep * velocity[k].v;
      EXPECT_EQ(of.search().predicted[k], x);
      moved = std::max(moved, (x - of.search().reference[k]).cwiseAbs().maxCoeff());
      way = std::max(way, (x - last[k]).cwiseAbs().maxCoeff());
    }
    EXPECT_EQ(of.search().moved[b], std::sqrt(Real(3)) * moved);
    EXPECT_EQ(of.search().path[b],
              std::nextafter(path[b] + std::sqrt(3.0) * static_cast<double>(way), HUGE_VAL));
  }
}

TEST(Follow, CountsWhatIsNoNumberOrBeyondTheSkinAsMoved) {
  for (const Real by : {Real(2), std::numeric_limits<Real>::quiet_NaN()}) {
    for (int axis = 0; axis < 3; ++axis) {
      Followed of;
      const Body& upper = of.scene.bodies[1];
      for (const int v : {upper.first_vertex, upper.first_vertex + upper.vertex_count - 1}) {
        of = Followed();
        of.found.workspace.velocity[static_cast<std::size_t>(v)].v[axis] =
            by * of.search().skin / kStep;
        EXPECT_TRUE(of.follow()) << by << ", axis " << axis;
        EXPECT_FALSE(of.search().renewed[0]);
        EXPECT_TRUE(of.search().renewed[1]);
      }
    }
  }
}

}  // namespace
}  // namespace stiction
