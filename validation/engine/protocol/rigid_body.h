// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/engine/engine.h"

namespace stiction {

/// What a body is when nothing deforms it: for the energies, momenta and pictures of engines that
/// tell poses and velocities alone.
class RigidBody {
 public:
  explicit RigidBody(const ProblemBody& body);

  /// Of translation and rotation, J.
  double kinetic_energy(const BodyMotion& motion) const;
  /// About the centre of mass, kg m²/s.
  Vec3 spin(const BodyMotion& motion) const;

  const Eigen::Matrix3Xi& surface() const { return surface_; }
  Eigen::Matrix3Xd vertices(const BodyMotion& motion) const;

 private:
  Eigen::Matrix3d inertia(const BodyMotion& motion) const;  // in the world's frame, kg m²

  double mass_;
  Eigen::Matrix3d inertia_;    // at the start, in the world's frame, kg m²
  Eigen::Matrix3Xd vertices_;  // about the centre, at the start, in the world's frame, m
  Eigen::Matrix3Xi surface_;
};

}  // namespace stiction
