// SPDX-License-Identifier: BSD-3-Clause
#include "solver/depth/border_average.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
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

// Eight prisms of 50° around an edge: the last lies in the first. A tetrahedron has a corner in both, near the edge,
// and another beyond the first one's open side, in the last.
SceneDescription folded() {
  TetMesh fan;
  fan.vertices.resize(3, 2 * 10);
  const auto put = [&](int k, double x, double y) {
    fan.vertices.col(2 * k) << x, y, -0.5;
    fan.vertices.col(2 * k + 1) << x, y, 0.5;
  };
  constexpr double kDegree = 3.14159265358979323846 / 180;
  put(9, 0.0, 0.0);
  for (int k = 0; k < 9; ++k) put(k, std::cos(50 * kDegree * k), std::sin(50 * kDegree * k));
  fan.tetrahedra.resize(4, 3 * 8);
  for (int k = 0; k < 8; ++k) {
    const int low[] = {18, 2 * k, 2 * k + 2}, high[] = {19, 2 * k + 1, 2 * k + 3};
    fan.tetrahedra.col(3 * k) << low[0], low[1], low[2], high[0];
    fan.tetrahedra.col(3 * k + 1) << low[1], low[2], high[0], high[1];
    fan.tetrahedra.col(3 * k + 2) << low[2], high[0], high[1], high[2];
  }
  TetMesh spike;
  spike.vertices.resize(3, 4);
  const auto at = [](double degrees, double radius, double z) {
    return Eigen::Vector3d(radius * std::cos(degrees * kDegree),
                           radius * std::sin(degrees * kDegree), z);
  };
  spike.vertices << at(20, 0.004, 0.03), at(-5, 0.3, 0.05), at(20, 0.01, 2.0), at(60, 0.1, 2.1);
  spike.tetrahedra.resize(4, 1);
  spike.tetrahedra << 0, 1, 2, 3;
  SceneDescription description;
  for (TetMesh* const mesh : {&fan, &spike}) {
    for (Eigen::Index e = 0; e < mesh->tetrahedra.cols(); ++e) {
      auto corner = mesh->tetrahedra.col(e);
      const auto x = [&](int k) { return mesh->vertices.col(corner(k)); };
      if ((x(1) - x(0)).cross(x(2) - x(0)).dot(x(3) - x(0)) < 0.0) std::swap(corner(2), corner(3));
    }
    description.bodies.push_back(test::elastic_body(*mesh));
  }
  description.bodies[0].name = "fan";
  description.bodies[1].name = "spike";
  return description;
}

TEST(AverageByOutlets, IsThatOfWalksInABodyThatFoldsOntoItself) {
  Overlap overlap(folded());
  const std::int32_t vertex = overlap.scene.bodies[1].first_vertex;
  int elements = 0;
  for (int e = 0; e < overlap.scene.bodies[0].element_count; ++e) {
    if (!overlap.is_in(vertex, e)) continue;
    ++elements;
    const Border border{overlap.scene, overlap.links, overlap.x, vertex, e, Real(1e-11)};
    Outlets outlets;
    outlets.element = e;
    EXPECT_GT(find_outlets(border, 1, overlap.scratch, outlets), 0.0);
    expect_same(average_by_outlets(border, outlets, lane_width(), overlap.scratch),
                average_by_walks(border, overlap.scratch));
  }
  EXPECT_EQ(elements, 2);
}

TEST(FindOutlets, HoldForAShareOfAnElementOrShorterWhereFewerAre) {
  Overlap overlap(overlapping(0.0, Vec3(0.21, 0.13, 0.999), 1));
  const Real longest = Real(1) / (3 * std::sqrt(Real(2))) / 60;  // of an altitude in a cube of ⅓
  Real longest_found = 0.0;
  int with_many = 0, with_few = 0;
  for (const Border& border : overlap.borders()) {
    Outlets many, few;
    many.element = few.element = border.element;
    // While bodies move so fast that nothing lasts, and while they rest.
    const Real in_haste = find_outlets(border, 1, overlap.scratch, many);
    const Real at_rest = find_outlets(border, 0, overlap.scratch, few);
    EXPECT_GT(at_rest, 0.0);
    EXPECT_LE(at_rest, in_haste);
    EXPECT_LE(few.count, many.count);
    longest_found = std::max(longest_found, in_haste);
    with_many += many.count;
    with_few += few.count;
  }
  EXPECT_NEAR(longest_found, longest, 100 * test::kEpsilon);
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
