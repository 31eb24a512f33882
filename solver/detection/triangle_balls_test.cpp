// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/triangle_balls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/lanes/lane_width.h"
#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

// Some of the triangles, full registers and not; others stay as they were.
TEST(TriangleBalls, AreThoseOfEachTriangleAlone) {
  SceneDescription description;
  for (int body = 0; body < 2; ++body) {
    description.bodies.push_back(test::elastic_body(test::cube_mesh(1)));
  }
  const Scene scene = build_scene(description);
  const Topology& topology = scene.topology;
  const Eigen::Matrix3Xd moved =
      scene.rest_position + test::noise(scene.rest_position.cols(), 0.2, 3);
  std::vector<Vec3> x;
  for (Eigen::Index k = 0; k < moved.cols(); ++k) x.push_back(moved.col(k));
  constexpr Real kMargin = 0.01;
  const std::size_t count = topology.triangle.size();
  ASSERT_GT(count, 20u);
  for (const int width : lane_widths()) {
    for (const std::size_t begin : {0, 3}) {
      for (std::size_t end = begin + 1; end <= count; ++end) {
        std::vector<TriangleBall> ball(count, {Vec3::Zero(), -1});
        bound_triangles(topology, begin, end, x, kMargin, width, ball);
        for (std::size_t t = 0; t < count; ++t) {
          if (t < begin || t >= end) {
            EXPECT_EQ(ball[t].radius, -1) << t;
            continue;
          }
          const auto corner = [&](int k) -> const Vec3& {
            return x[static_cast<std::size_t>(topology.triangle[t].vertex[k])];
          };
          const Vec3 centre = (corner(0) + corner(1) + corner(2)) / 3;
          Real radius2 = 0;
          for (int k = 0; k < 3; ++k) {
            radius2 = std::max(radius2, (corner(k) - centre).squaredNorm());
          }
          EXPECT_EQ(ball[t].centre, centre) << t << ", width " << width;
          EXPECT_EQ(ball[t].radius, std::sqrt(radius2) + kMargin) << t << ", width " << width;
        }
      }
    }
  }
}

}  // namespace
}  // namespace stiction
