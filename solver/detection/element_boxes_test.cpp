// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/element_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "solver/lanes/lane_width.h"
#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

constexpr Real kMargin = 0.125;

struct Two {
  Scene scene;
  std::vector<Vec3> x;

  Two() {
    SceneDescription description;
    for (const int cells : {1, 3}) {
      description.bodies.push_back(test::elastic_body(test::cube_mesh(cells)));
    }
    scene = build_scene(description);
    const Eigen::Matrix3Xd moved =
        scene.rest_position + test::noise(scene.rest_position.cols(), 0.2, 3);
    for (Eigen::Index k = 0; k < moved.cols(); ++k) x.push_back(moved.col(k));
  }

  Box3 box(int element) const {
    Box3 box;
    for (const std::int32_t v : scene.elements[static_cast<std::size_t>(element)].vertex) {
      box.extend(x[static_cast<std::size_t>(v)]);
    }
    return {box.min() - Vec3::Constant(kMargin), box.max() + Vec3::Constant(kMargin)};
  }
};

using Held = std::vector<std::pair<int, int>>;  // a point, and the element whose box holds it

// Every so many of the vertices of both bodies.
std::vector<int> points_of(const Two& two, std::size_t first, std::size_t every) {
  std::vector<int> points;
  for (std::size_t k = first; k < two.x.size(); k += every) points.push_back(static_cast<int>(k));
  return points;
}

template <int Bytes>
Held held_at(const Two& two, ElementBoxes& boxes, const std::vector<int>& points) {
  SpatialHash hash;
  hash.clear(0.4);
  for (const int k : points) hash.add(k, two.x[static_cast<std::size_t>(k)]);
  Held held;
  boxes.for_each_holding<Bytes>(hash, [&](int point, int element) {
    held.push_back({point, element});
  });
  // Of one point they come in the order of the elements, points in any.
  std::stable_sort(held.begin(), held.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  return held;
}

Held expected_of(const Two& two, const Body& body, const std::vector<int>& points,
                 const Box3& within) {
  Held expected;
  for (const int k : points) {
    for (int e = body.first_element; e < body.first_element + body.element_count; ++e) {
      const Box3 box = two.box(e);
      if (!box.intersects(within)) continue;
      if (box.contains(two.x[static_cast<std::size_t>(k)])) expected.push_back({k, e});
    }
  }
  return expected;
}

// Whether `held` are all that are expected, and beside them only such as are held by boxes wider by a 255th of
// the body.
void expect_held(const Two& two, const Body& body, const Held& held, const Held& expected,
                 const std::string& where) {
  Box3 all;
  for (int e = body.first_element; e < body.first_element + body.element_count; ++e) {
    all.extend(two.box(e));
  }
  const Vec3 part = all.sizes() / 255;
  EXPECT_TRUE(std::includes(held.begin(), held.end(), expected.begin(), expected.end())) << where;
  EXPECT_EQ(std::adjacent_find(held.begin(), held.end()), held.end()) << where;
  for (const auto& [point, element] : held) {
    const Box3 box = two.box(element);
    EXPECT_TRUE(
        Box3(box.min() - part, box.max() + part).contains(two.x[static_cast<std::size_t>(point)]))
        << where << ": " << point << " in " << element;
  }
}

// One body has fewer elements than a block and the other more than a word has bits; points are a few, each
// compared with all, and many, which are looked up; within some boxes are all elements, and within others none.
TEST(ElementBoxes, HoldWhatComparingWithEachFinds) {
  const Two two;
  std::size_t most = 0;
  for (unsigned seed = 0; seed < 30; ++seed) {
    const Eigen::Matrix3Xd ends = test::noise(2, 1.5, 100 + seed);
    const Box3 within = seed == 0 ? Box3(Vec3::Constant(-9), Vec3::Constant(9))
                                  : Box3(Vec3(ends.col(0).cwiseMin(ends.col(1))),
                                         Vec3(ends.col(0).cwiseMax(ends.col(1))));
    for (const std::size_t every : {1, 5, 40}) {
      const std::vector<int> points = points_of(two, seed % every, every);
      for (const Body& body : two.scene.bodies) {
        const Held expected = expected_of(two, body, points, within);
        most = std::max(most, expected.size());
        Held first;
        for (const int width : lane_widths()) {
          const std::string where =
              "width " + std::to_string(width) + ", seed " + std::to_string(seed);
          ElementBoxes boxes;
          boxes.bound(two.scene, body, two.x, kMargin, within, width);
          const Held held = held_at<16>(two, boxes, points);
          expect_held(two, body, held, expected, where);
          if (width == lane_widths().front()) first = held;
          EXPECT_EQ(held, first) << where;
          EXPECT_EQ(held_at<32>(two, boxes, points), first) << where;
          EXPECT_EQ(held_at<64>(two, boxes, points), first) << where;
        }
      }
    }
  }
  EXPECT_GT(most, 1000u);
}

// Of a body with fewer than before nothing is left.
TEST(ElementBoxes, ForgetTheBodyBefore) {
  const Two two;
  const Box3 everywhere(Vec3::Constant(-9), Vec3::Constant(9));
  const std::vector<int> points = points_of(two, 0, 1);
  ElementBoxes boxes;
  for (const std::size_t b : {1, 0}) {
    const Body& body = two.scene.bodies[b];
    boxes.bound(two.scene, body, two.x, kMargin, everywhere, lane_width());
    EXPECT_EQ(boxes.size(), static_cast<std::size_t>(body.element_count));
    expect_held(two, body, held_at<16>(two, boxes, points),
                expected_of(two, body, points, everywhere), "body " + std::to_string(b));
  }
}

}  // namespace
}  // namespace stiction
