// SPDX-License-Identifier: BSD-3-Clause
#include "solver/scene/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "solver/scene/time_step_limit.h"
#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

TEST(BuildScene, LumpsMassesThatSumUpToDensityTimesVolume) {
  Material material;
  material.density = 700.0;
  const Scene scene = build_scene(test::one_body(test::elastic_body(test::cube_mesh(3), material)));
  // Round-off: 4 · 162 quarters are added.
  EXPECT_NEAR(std::accumulate(scene.mass.begin(), scene.mass.end(), 0.0), 700.0,
              700.0 * 648 * test::kEpsilon);
  EXPECT_NEAR(scene.bodies[0].mass, 700.0, 700.0 * 648 * test::kEpsilon);
}

TEST(BuildScene, GivesEachCornerAQuarterOfItsTetrahedron) {
  const Scene scene = build_scene(test::one_body(test::elastic_body(test::corner_tetrahedron())));
  for (const double mass : scene.mass) EXPECT_DOUBLE_EQ(mass, 1000.0 / 24.0);
}

TEST(BuildScene, MapsDescribedVerticesToTheirPlaces) {
  BodyDescription body = test::elastic_body(test::cube_mesh(2));
  body.initial_velocity = test::noise(27, 1.0, 1);
  SceneDescription description = test::one_body(body);
  description.bodies.push_back(body);
  const Scene scene = build_scene(description);
  ASSERT_EQ(scene.vertex_count(), 54);
  const std::set<int> places(scene.scene_vertex.begin(), scene.scene_vertex.end());
  EXPECT_EQ(places.size(), 54u);
  for (int k = 0; k < 54; ++k) {
    const int place = scene.scene_vertex[static_cast<std::size_t>(k)];
    EXPECT_EQ(scene.rest_position.col(place), body.mesh.vertices.col(k % 27));
    EXPECT_EQ(scene.initial_velocity.col(place), body.initial_velocity.col(k % 27));
    EXPECT_EQ(place >= 27, k >= 27) << "a body's vertices are contiguous";
  }
  EXPECT_EQ(scene.bodies[1].first_vertex, 27);
  EXPECT_EQ(scene.bodies[1].vertex_count, 27);
}

TEST(BuildScene, ListsSurfaceVerticesOfAllBodiesInIncreasingOrder) {
  SceneDescription description = test::one_body(test::elastic_body(test::cube_mesh(2)));
  description.bodies.push_back(description.bodies[0]);
  const Scene scene = build_scene(description);
  EXPECT_EQ(scene.surface_vertex.size(), 2u * 26u);  // one vertex of 27 lies inside
  EXPECT_TRUE(std::is_sorted(scene.surface_vertex.begin(), scene.surface_vertex.end()));
  for (const int v : scene.surface_vertex) {
    EXPECT_NE(Vec3(scene.rest_position.col(v)), Vec3::Constant(0.5));
  }
}

TEST(BuildScene, PutsElementsByTheirFirstVertexAndThoseOfALargeBodyByTheirLast) {
  const auto ranks = [](int cells, auto extreme) {
    const Scene scene = build_scene(test::one_body(test::elastic_body(test::cube_mesh(cells))));
    EXPECT_EQ(scene.elements.size(), static_cast<std::size_t>(6 * cells * cells * cells));
    std::vector<int> rank;
    for (const Element& e : scene.elements) rank.push_back(*extreme(e.vertex, e.vertex + 4));
    return rank;
  };
  const auto first = [](const int* a, const int* b) { return std::min_element(a, b); };
  const auto last = [](const int* a, const int* b) { return std::max_element(a, b); };
  const auto ordered = [](const std::vector<int>& r) { return std::is_sorted(r.begin(), r.end()); };
  EXPECT_TRUE(ordered(ranks(3, first)));
  EXPECT_FALSE(ordered(ranks(3, last)));
  EXPECT_TRUE(ordered(ranks(12, last)));
  EXPECT_FALSE(ordered(ranks(12, first)));
}

TEST(BuildScene, StopsPinnedVertices) {
  BodyDescription body = test::elastic_body(test::corner_tetrahedron());
  body.initial_velocity = Eigen::Matrix3Xd::Ones(3, 4);
  body.pinned = {2};
  const Scene scene = build_scene(test::one_body(body));
  for (int k = 0; k < 4; ++k) {
    const int place = scene.scene_vertex[static_cast<std::size_t>(k)];
    const double inverse = scene.inverse_mass[static_cast<std::size_t>(place)];
    if (k == 2) {
      EXPECT_EQ(inverse, 0.0);
      EXPECT_EQ(Vec3(scene.initial_velocity.col(place)), Vec3::Zero());
    } else {
      EXPECT_DOUBLE_EQ(inverse * scene.mass[static_cast<std::size_t>(place)], 1.0);
      EXPECT_EQ(Vec3(scene.initial_velocity.col(place)), Vec3::Ones());
    }
  }
  EXPECT_DOUBLE_EQ(scene.bodies[0].mass, 1000.0 / 6.0) << "pinned vertices included";
}

TEST(BuildScene, OfPointMassesHasNoTimeStepLimit) {
  const Scene scene =
      build_scene(test::one_body(test::point_masses(Eigen::Matrix3Xd::Zero(3, 1), 2.0)));
  EXPECT_EQ(scene.stable_time_step, test::kInfinity);
  EXPECT_EQ(scene.mass, std::vector<double>{2.0});
}

TEST(BuildScene, NamesTheElementAndBodyThatLimitTheTimeStep) {
  SceneDescription description = test::one_body(test::elastic_body(test::cube_mesh(1)));
  BodyDescription other = test::elastic_body(test::cube_mesh(1));
  other.name = "with a thin one";
  // Squeezes the cell's tetrahedra unevenly: whichever brute force finds stiffest must be named.
  other.mesh.vertices.col(1) += Vec3(-0.4, 0.2, 0.1);
  description.bodies.push_back(other);
  const Scene scene = build_scene(description);
  int stiffest = -1;
  double smallest = test::kInfinity;
  for (int e = 0; e < 6; ++e) {
    const double limit = element_time_step_limit(other.mesh, e, other.material);
    if (limit < smallest) {
      smallest = limit;
      stiffest = 6 + e;
    }
  }
  EXPECT_EQ(scene.stable_time_step, smallest);
  EXPECT_EQ(scene.stiffest_element, stiffest);
  EXPECT_EQ(scene.stiffest_body, "with a thin one");
}

TEST(SceneSerial, IsAnotherOfACopyAndTheSameOfWhatWasMoved) {
  const SceneDescription one = test::one_body(test::elastic_body(test::corner_tetrahedron()));
  Scene scene = build_scene(one);
  const std::uint64_t serial = scene.serial;
  const Scene copy = scene;
  EXPECT_NE(copy.serial, serial);
  Scene assigned = build_scene(one);
  assigned = scene;
  EXPECT_NE(assigned.serial, serial);
  EXPECT_NE(assigned.serial, copy.serial);
  const Scene moved = std::move(scene);
  EXPECT_EQ(moved.serial, serial);
}

}  // namespace
}  // namespace stiction
