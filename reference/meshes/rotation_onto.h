// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>

namespace stiction::reference {

/// The least rotation that turns one direction onto another, neither of them zero; a half turn
/// about anything across them where they are opposite. It is what Eigen's FromTwoVectors gives,
/// without its singular value decomposition, which takes four seconds to compile wherever it is
/// used.
inline Eigen::Quaterniond rotation_onto(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d a = from.normalized(), b = to.normalized();
  const double cosine = b.dot(a);
  Eigen::Quaterniond rotation;
  if (cosine < -1.0 + 1e-12) {
    rotation.w() = 0.0;
    rotation.vec() = a.unitOrthogonal();
    return rotation;
  }
  const double twice = std::sqrt((1.0 + cosine) * 2.0);
  rotation.w() = twice * 0.5;
  rotation.vec() = a.cross(b) * (1.0 / twice);
  return rotation;
}

}  // namespace stiction::reference
