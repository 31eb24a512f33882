// SPDX-License-Identifier: BSD-3-Clause
#include "solver/depth/border_average.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/depth/consistent_depth.h"
#include "solver/depth/find_outlets.h"
#include "solver/detection/holding.h"
#include "solver/lanes/lane_width.h"
#include "solver/testing/test_pairs.h"

namespace stiction {
namespace {

// Two bodies that overlap, and the borders of the second one's vertices in the first.
struct Overlap {
  Scene scene;
  std::vector<Vec3> x;
  MeshLinks links;
  WalkScratch scratch;

  explicit Overlap(const SceneDescription& description) : scene(build_scene(description)) {
    for (const Position& at : initial_state(scene).position) x.push_back(at.x);
    build_links(scene, links);
    renew();
  }
  // After positions have changed.
  void renew() { scratch.begin(scene.elements.size(), scene.topology.triangle.size()); }

  bool is_in(std::int32_t vertex, std::int32_t element) const {
    const auto& v = scene.elements[static_cast<std::size_t>(element)].vertex;
    const auto at = [&](std::int32_t k) { return x[static_cast<std::size_t>(k)]; };
    return barycentric(at(vertex), at(v[0]), at(v[1]), at(v[2]), at(v[3])).minCoeff() >= 0.0;
  }
  std::vector<Border> borders() const {
    std::vector<Border> all;
    const Body &holder = scene.bodies[0], &own = scene.bodies[1];
    for (int v = own.first_vertex; v < own.first_vertex + own.vertex_count; ++v) {
      for (int e = holder.first_element; e < holder.first_element + holder.element_count; ++e) {
        if (!is_in(v, e)) continue;
        all.push_back({scene, links, x, v, e, kConsistentThin * links.longest_edge[0]});
        break;
      }
    }
    return all;
  }
  // Each vertex by so much at most, in a direction of its own.
  void move(const std::vector<Vec3>& from, double first_body, double second_body, unsigned seed) {
    const Eigen::Matrix3Xd ways = test::noise(static_cast<Eigen::Index>(x.size()), 1.0, seed);
    const auto second = static_cast<std::size_t>(scene.bodies[1].first_vertex);
    for (std::size_t v = 0; v < x.size(); ++v) {
      const Vec3 way = ways.col(static_cast<Eigen::Index>(v)).cast<Real>().normalized();
      x[v] = from[v] + static_cast<Real>(v < second ? first_body : second_body) * way;
    }
    renew();
  }
};

SceneDescription overlapping(double noise, const Vec3& shift, unsigned seed) {
  SceneDescription description;
  description.bodies = {test::elastic_body(test::cube_mesh(3)),
                        test::elastic_body(test::cube_mesh(2))};
  description.bodies[0].name = "lower";
  description.bodies[1].name = "upper";
  description.bodies[1].mesh.vertices.colwise() += shift;
  for (BodyDescription& body : description.bodies) {
    body.mesh.vertices += test::noise(body.mesh.vertices.cols(), noise, ++seed);
  }
  return description;
}

void expect_same(const Average& a, const Average& b) {
  EXPECT_EQ(a.weight, b.weight);
  EXPECT_EQ(a.depth, b.depth);
  EXPECT_EQ(a.normal, b.normal);
}

struct Asked {
  int known = 0, changed = 0;
};

// Finds the outlets of all borders, moves the bodies by nearly as much as these hold for, and looks whether the
// averages are those of walks.
Asked ask(Overlap& overlap, double stride) {
  Asked asked;
  const std::vector<Vec3> start = overlap.x;
  for (const Border& border : overlap.borders()) {
    overlap.move(start, 0.0, 0.0, 1);
    Outlets outlets;
    outlets.element = border.element;
    const double within = find_outlets(border, static_cast<Real>(stride), overlap.scratch, outlets);
    if (!(within > 0.0)) continue;
    ++asked.known;
    const Average before = average_by_walks(border, overlap.scratch);
    for (unsigned seed = 1; seed <= 12; ++seed) {
      const double share = 0.999 * (seed % 4) / 3;
      overlap.move(start, share * within, (0.999 - share) * within, seed);
      if (!overlap.is_in(border.vertex, border.element)) continue;
      const Average expected = average_by_walks(border, overlap.scratch);
      for (const int width : lane_widths()) {
        expect_same(average_by_outlets(border, outlets, width, overlap.scratch), expected);
      }
      asked.changed += expected.depth != before.depth;
    }
  }
  return asked;
}

TEST(AverageByOutlets, IsThatOfWalksHoweverBodiesHaveMoved) {
  Asked all;
  for (unsigned seed = 0; seed < 24; ++seed) {
    const Vec3 shift = Vec3(0.2, 0.3, 0.4) + test::noise(1, 0.4, 100 + seed).col(0).cast<Real>();
    Overlap overlap(overlapping(0.04, shift, 10 * seed));
    const Asked asked = ask(overlap, seed % 2 == 0 ? 0.0 : 1e-6);
    all.known += asked.known;
    all.changed += asked.changed;
  }
  EXPECT_GT(all.known, 100);
  EXPECT_GT(all.changed, 1000);
}

// Faces, edges and corners in one plane, or above each other.
TEST(AverageByOutlets, IsThatOfWalksWhereBodiesAreFlush) {
  Asked all;
  for (const double depth : {0.25, 1e-2, 1e-4, 1e-6, 1e-9}) {
    for (const Vec3& side : {Vec3(0, 0, 1), Vec3(0.5, 0, 1), Vec3(1.0 / 3, 1.0 / 3, 1)}) {
      Overlap overlap(overlapping(0.0, Vec3(side - Vec3(0, 0, depth)), 1));
      const Asked asked = ask(overlap, 0.0);
      all.known += asked.known;
      all.changed += asked.changed;
    }
  }
  EXPECT_GT(all.known, 20);
  EXPECT_GT(all.changed, 100);
}

TEST(FindOutlets, HoldForAShareOfAnElementOrShorterWhereFewerAre) {
  Overlap overlap(overlapping(0.0, Vec3(0.21, 0.13, 0.999), 1));
  const Real longest = Real(1) / (3 * std::sqrt(Real(2))) / 60;  // of an altitude in a cube of ⅓
  int with_many = 0, with_few = 0;
  for (const Border& border : overlap.borders()) {
    Outlets many, few;
    many.element = few.element = border.element;
    // While bodies move so fast that nothing lasts, and while they rest.
    EXPECT_NEAR(find_outlets(border, 1, overlap.scratch, many), longest, 100 * test::kEpsilon);
    const Real within = find_outlets(border, 0, overlap.scratch, few);
    EXPECT_GT(within, 0.0);
    EXPECT_LE(within, longest);
    EXPECT_LE(few.count, many.count);
    with_many += many.count;
    with_few += few.count;
  }
  EXPECT_LT(with_few, with_many);
}

TEST(FindOutlets, OfAFlatElementAreNotKnown) {
  Overlap flat(overlapping(0.0, Vec3(0.21, 0.13, 0.9), 1));
  const std::vector<Border> borders = flat.borders();
  for (Vec3& x : flat.x) x.z() = 0.5;
  flat.renew();
  for (const Border& border : borders) {
    Outlets outlets;
    outlets.element = border.element;
    EXPECT_EQ(find_outlets(border, 0, flat.scratch, outlets), 0.0);
  }
}

}  // namespace
}  // namespace stiction
