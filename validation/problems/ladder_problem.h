// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "validation/engine/problem.h"

namespace stiction {

/// A body of a ladder's scene: a box of `cells` cells along its longest edge, as a mesh of its own, so
/// that each engine gets the same.
struct LadderBox {
  Vec3 size{0.1, 0.1, 0.1};  ///< m
  int cells = 1;
  double density = 1000.0;  ///< kg/m³
  /// β · E = 1000 Pa s
  Elasticity elasticity{.youngs_modulus = 1e7, .poisson_ratio = 0.3, .damping_time = 1e-4};
  Vec3 position = Vec3::Zero();  ///< of its centre, m
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Vec3 velocity = Vec3::Zero();          ///< m/s
  Vec3 angular_velocity = Vec3::Zero();  ///< rad/s
  bool held = false;                     ///< its lower face is
};
ProblemBody ladder_body(const LadderBox& box, const std::string& name);

/// Times of a scene that is loaded, settles in a medium and is then watched, s.
inline constexpr double kLadderPressed = 0.2, kLadderTilted = 0.6, kLadderDragFull = 1.5,
                        kLadderDragEnds = 2.0, kLadderSettled = 2.5, kLadderWindow = 1.0;

/// Of the scenes that differ in other things.
inline constexpr double kLadderFriction = 0.5, kLadderTanSlope = 0.1;

/// Boxes, each on the one before it or as `bodies` say, the first of them held; gravity grows into
/// them and is then turned by atan(tan θ) towards x, and a medium of `drag` (1/s) damps what swings
/// until kLadderDragEnds.
Problem ladder_problem(const std::vector<LadderBox>& boxes, double friction, double tan_slope,
                       double drag = 60.0);

/// A box on a larger slab that is held below; the upper box's position is what it is shifted by.
std::vector<LadderBox> box_on_slab(LadderBox box, LadderBox slab);

}  // namespace stiction
