// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/gauntlet/balance_problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

namespace {

constexpr double kEdge = 0.05;       // of a perch, m: it fits between the legs
constexpr double kSpikeSlope = 0.5;  // tangent of its sides' slope
const double kValleySlope = std::sqrt(1.0 / 3.0);

constexpr double kBlock = 0.03;                                                      // m
constexpr double kSpikeEdge = 0.056, kSpikeHeight = 0.5 * kSpikeEdge * kSpikeSlope;  // m

ProblemBody perch_of(const BalanceSetup& setup) {
  const auto held = [&](TetMesh mesh, double lowest, double place) {
    return held_gauntlet_body("perch", std::move(mesh), lowest, Vec3(0.0, 0.0, place),
                              yawed(setup.perch_yaw));
  };
  switch (setup.perch) {
    case Perch::kFlat:
      return held(flat_mesh(kEdge, kBlock, 2, false), -kBlock, 0.0);
    case Perch::kSpike:
      return held(spike_bed_mesh({.pad = kSpikeEdge, .height = kSpikeHeight, .block = kBlock}),
                  -kBlock, -kSpikeHeight);
    case Perch::kRidge:
      return held(
          wedge_mesh({.width = kEdge, .height = 0.5 * kEdge, .block = kBlock, .length = kEdge}),
          -kBlock, -0.5 * kEdge);
    case Perch::kValley:
      return held(valley_mesh({.width = kEdge,
                               .depth = 0.5 * kEdge * kValleySlope,
                               .block = kBlock,
                               .length = kEdge}),
                  -kBlock, 0.0);
  }
  throw std::logic_error("no such perch");
}

// Of the perch's surface under a point of its own, over its middle.
double height_of(Perch perch, const Vec2& at) {
  switch (perch) {
    case Perch::kFlat:
      return 0.0;
    case Perch::kSpike:
      return -kSpikeSlope * at.cwiseAbs().maxCoeff();
    case Perch::kRidge:
      return -std::abs(at.x());
    case Perch::kValley:
      return kValleySlope * std::abs(at.x());
  }
  throw std::logic_error("no such perch");
}

}  // namespace

Vec3 foot_at(const BalanceSetup& setup) {
  const Vec3 offset(setup.offset.x(), setup.offset.y(), 0.0);
  const Vec3 own = yawed(setup.perch_yaw).inverse() * offset;
  // A face, or an edge, stands on the highest point that it covers.
  const bool point = setup.foot == Foot::kSpike;
  return offset + Vec3(0.0, 0.0, point ? height_of(setup.perch, own.head<2>()) : 0.0);
}

Problem balance_problem(const BalanceSetup& setup) {
  Problem problem;
  problem.name = "balance";
  problem.bodies = {gauntlet_body("balancing body", balancer_mesh(setup.foot), foot_at(setup),
                                  yawed(setup.foot_yaw)),
                    perch_of(setup)};
  problem.friction = setup.friction;
  problem.gravity = {{0.0, 0.4}, {Vec3::Zero(), Vec3(0.0, 0.0, -kStandardGravity)}};
  problem.drag = {.rate = setup.foot == Foot::kNone ? 15.0 : 11.0, .full_until = 3.4, .ends = 3.7};
  return problem;
}

std::string balance_words(const BalanceSetup& setup) {
  const char* const feet[] = {"hook", "spike", "ridge"};
  const char* const perches[] = {"flat", "spike", "ridge", "valley"};
  return fmt::format(
      "{} on {}, ({:.0f}, {:.0f}) mm off, turned by {:.0f}°, perch by {:.0f}°, μ = {:g}",
      feet[static_cast<int>(setup.foot)], perches[static_cast<int>(setup.perch)],
      1e3 * setup.offset.x(), 1e3 * setup.offset.y(), setup.foot_yaw, setup.perch_yaw,
      setup.friction);
}

}  // namespace stiction
