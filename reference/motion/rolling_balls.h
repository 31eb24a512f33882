// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace stiction::reference {

/// A rigid ball. `centre` in m.
struct RigidBall {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 1.0;  ///< m
  double mass = 1.0;    ///< kg
};

/// Two balls that touch at a point; `a` = −1 is level ground below b.
struct BallContact {
  int a = -1;
  int b = 0;
};

/// What balls in equilibrium do that roll on each other at single points without slipping.
struct RollingMotions {
  Eigen::VectorXd friction;  ///< per contact: |f|/fⁿ of the one equilibrium, dimensionless
  double residual = 0.0;     ///< of the equilibrium, N
  /// Squares of the rates (1/s²) at which small motions without slip grow (> 0) or vibrate (< 0);
  /// 0 is neutral: nothing drives the motion and nothing opposes it.
  Eigen::VectorXd rates2;
  /// 6·balls × motions: velocity and angular velocity of each ball in the motions without slip.
  Eigen::MatrixXd basis;
};

/// Linearises M w' = F + Jᵀλ, J(x) w = 0 about rest, for centres and angular velocities w and the
/// contact forces λ: with a basis N of J's kernel, NᵀMN a' = Nᵀ (∂Jᵀ/∂x · x̃) λ, x̃' = N a. Gravity
/// (m/s²) acts along −z. Throws std::invalid_argument if balls don't touch (to 1e-9 of a radius).
RollingMotions rolling_motions(const std::vector<RigidBall>& balls,
                               const std::vector<BallContact>& contacts, double gravity);

}  // namespace stiction::reference
