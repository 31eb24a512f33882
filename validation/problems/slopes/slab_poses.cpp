// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/slopes/slab_poses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "reference/limit/limit_analysis.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

namespace {

constexpr double kHalf = 0.5 * kSlabWidth;
constexpr double kMostTan = 0.4877;  // tan 26°

double sign_of(std::uint_fast32_t bits) { return bits % 2 == 0 ? 1.0 : -1.0; }

}  // namespace

double critical_tan(const SlabSetup& setup) {
  const auto clipped = [](double x) { return std::clamp(x, -kHalf, kHalf); };
  const Vec3 half = 0.5 * setup.box_size;
  reference::LimitProblem rigid;
  rigid.bodies = {{1.0, Vec3(setup.offset.x(), setup.offset.y(), half.z())}};
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      reference::ContactPoint corner;
      corner.point = Vec3(clipped(setup.offset.x() + x * half.x()),
                          clipped(setup.offset.y() + y * half.y()), 0.0);
      rigid.contacts.push_back(corner);
    }
  }
  rigid.live_gravity = kStandardGravity * slab_downhill(setup);
  return reference::in_nine_digits(reference::critical_load(rigid, setup.friction).lower);
}

std::vector<PosedSlab> posed_slabs(int count, std::uint32_t seed) {
  std::mt19937 generator(seed);
  // The library's distributions differ from compiler to compiler.
  const auto uniform = [&](double from, double to) {
    return from + (to - from) * (static_cast<double>(generator()) / 4294967296.0);
  };
  std::vector<PosedSlab> all;
  for (int k = 0; k < count; ++k) {
    PosedSlab posed;
    posed.pose = static_cast<SlabPose>(k % kPoses);
    SlabSetup& setup = posed.setup;
    const double a = uniform(0.08, 0.12), b = uniform(0.08, 0.12), c = uniform(0.08, 0.12);
    setup.box_size = Vec3(a, b, c);
    setup.azimuth = uniform(0.0, 2.0 * std::numbers::pi);
    const double tangent = uniform(0.0, kMostTan);
    const double across = uniform(-0.02, 0.02), along = uniform(-0.02, 0.02);
    const double yaw = uniform(0.0, 0.5 * std::numbers::pi);
    const double x_side = sign_of(generator()), y_side = sign_of(generator());
    setup.cells = 2 + static_cast<int>(generator() % 2u);
    setup.slab_cells = 3 + static_cast<int>(generator() % 2u);
    switch (posed.pose) {
      case SlabPose::kAnywhere:
        setup.offset = Vec3(along, across, 0.0);
        setup.yaw = yaw;
        break;
      case SlabPose::kFlush:
        setup.offset = Vec3(x_side * (kHalf - 0.5 * a), across, 0.0);
        break;
      case SlabPose::kCorner:
        setup.offset = Vec3(x_side * (kHalf - 0.5 * a), y_side * (kHalf - 0.5 * b), 0.0);
        break;
      case SlabPose::kCovering:
        setup.box_size = Vec3(kSlabWidth, kSlabWidth, c);
        break;
      case SlabPose::kHanging:
        setup.offset = Vec3(x_side * (kHalf - 0.1 * a), across, 0.0);
        break;
    }
    const double most = posed.pose == SlabPose::kAnywhere
                            ? kMostTan
                            : std::min(kMostTan, 0.8 * critical_tan(setup));
    setup.slope = std::atan(tangent * most / kMostTan);
    all.push_back(posed);
  }
  return all;
}

std::string pose_words(const PosedSlab& posed) {
  const char* const words[kPoses] = {"anywhere", "flush with an edge", "corner on corner",
                                     "covering the slab", "hanging over an edge"};
  return fmt::format("{}, {}", words[static_cast<int>(posed.pose)], slab_words(posed.setup));
}

}  // namespace stiction
