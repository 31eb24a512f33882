// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/element_boxes.h"

#include <gtest/gtest.h>

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

struct Seen {
  std::vector<int> element;
  std::vector<Vec3> low, high;
  bool operator==(const Seen&) const = default;

  void add(int e, const Box3& box) {
    element.push_back(e);
    low.push_back(box.min());
    high.push_back(box.max());
  }
};

template <int Bytes>
Seen seen_at(const ElementBoxes& boxes, const Box3& around) {
  Seen seen;
  boxes.for_each_at<Bytes>(around, [&](int e, const Box3& box) { seen.add(e, box); });
  return seen;
}

// One body has fewer elements than a block and the other more; within some boxes are all of them, and
// within others none.
TEST(ElementBoxes, AreThoseOfTheElementsThatMeetTwoBoxes) {
  const Two two;
  int most = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Eigen::Matrix3Xd ends = test::noise(4, 1.5, 100 + seed);
    const auto between = [&](int k) {
      return Box3(Vec3(ends.col(k).cwiseMin(ends.col(k + 1))),
                  Vec3(ends.col(k).cwiseMax(ends.col(k + 1))));
    };
    const Box3 within = between(0), around = between(2);
    for (const Body& body : two.scene.bodies) {
      Seen kept, wanted;
      for (int e = body.first_element; e < body.first_element + body.element_count; ++e) {
        const Box3 box = two.box(e);
        if (!box.intersects(within)) continue;
        kept.add(e, box);
        if (box.intersects(around)) wanted.add(e, box);
      }
      most = std::max(most, static_cast<int>(wanted.element.size()));
      for (const int width : lane_widths()) {
        ElementBoxes boxes;
        boxes.bound(two.scene, body, two.x, kMargin, within, width);
        EXPECT_EQ(boxes.size(), kept.element.size());
        EXPECT_EQ(seen_at<16>(boxes, around), wanted) << "width " << width << ", seed " << seed;
        EXPECT_EQ(seen_at<32>(boxes, around), wanted) << "width " << width << ", seed " << seed;
        EXPECT_EQ(seen_at<64>(boxes, around), wanted) << "width " << width << ", seed " << seed;
      }
    }
  }
  EXPECT_GT(most, 20);
}

// Of a body with fewer than before nothing is left.
TEST(ElementBoxes, ForgetTheBodyBefore) {
  const Two two;
  const Box3 everywhere(Vec3::Constant(-9), Vec3::Constant(9));
  ElementBoxes boxes;
  for (const std::size_t b : {1, 0}) {
    const Body& body = two.scene.bodies[b];
    boxes.bound(two.scene, body, two.x, kMargin, everywhere, lane_width());
    EXPECT_EQ(seen_at<16>(boxes, everywhere).element.size(),
              static_cast<std::size_t>(body.element_count));
  }
}

}  // namespace
}  // namespace stiction
