// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "validation/engine/problem.h"

namespace stiction {

/// How a scene is seen by somebody else: turned, moved, mirrored, in other units, in passing. A
/// point x at time t is seen at
///
///   x' = length · turn · x + shift + drift · t',   t' = time · t
///
/// Newton's and Coulomb's laws say the same of both. Where a factor is 1 and a vector zero nothing
/// is rounded.
struct ReferenceFrame {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  ///< orthogonal; det −1 mirrors
  Vec3 shift = Vec3::Zero();                           ///< in the new unit of length
  Vec3 drift = Vec3::Zero();                           ///< in the new units
  double length = 1.0;                                 ///< new units of length in a metre
  double mass = 1.0;                                   ///< … of mass in a kilogram
  double time = 1.0;                                   ///< … of time in a second

  bool mirrors() const { return turn.determinant() < 0.0; }
  double force() const { return mass * length / (time * time); }
  double energy() const { return force() * length; }
  double momentum() const { return mass * length / time; }

  /// The same scene, as seen from there. A mirrored box or ball is one of the same shape. Throws
  /// NotApplicable for a scene that settles in a medium, whose frame cannot be left by drifting.
  Problem seen(const Problem& problem) const;

  Vec3 turned(const Vec3& v) const { return turn * v; }
  Vec3 turned_back(const Vec3& v) const { return turn.transpose() * v; }
  /// Of a vector that stands for a turn: angular velocity, couple, angular momentum.
  Vec3 axial(const Vec3& v) const { return mirrors() ? Vec3(-(turn * v)) : Vec3(turn * v); }
  Vec3 axial_back(const Vec3& v) const {
    return mirrors() ? Vec3(-(turn.transpose() * v)) : Vec3(turn.transpose() * v);
  }

  // Seen there at time t' → as it is here.
  Vec3 position_back(const Vec3& x, double seen_time) const;
  Vec3 velocity_back(const Vec3& v) const;
  /// Of a rotation from the initial pose.
  Eigen::Quaterniond rotation_back(const Eigen::Quaterniond& rotation) const;
};

}  // namespace stiction
