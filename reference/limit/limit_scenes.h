// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "reference/limit/limit_analysis.h"

/// Scenes with known answers. Gravity acts along −z; live gravity along x, so that λ = tan θ.
namespace stiction::reference {

/// A box of sides `size`, m, and `mass`, kg, on the plane z = 0: four corner contacts.
/// Critical λ: min(μ, size_x / size_z).
LimitProblem box_on_incline(const Eigen::Vector3d& size, double mass);

/// `boxes` boxes of sides `size`, m, and equal mass, exactly on each other on the plane z = 0: four
/// corner contacts a joint. Critical λ: min(μ, size_x / (boxes size_z)).
LimitProblem box_stack(int boxes, const Eigen::Vector3d& size);

/// Rows of n, n − 1, …, 1 cubes of edge 1 m and mass 1 kg, `gap` ≥ 0 (m) apart along x. With
/// `touching` sides (and gap = 0) neighbours can push each other. Flat patches are given by their
/// corners.
LimitProblem box_pyramid(int rows, double gap, bool touching);

/// A ball of radius `ratio`, m, on three of radius 1 m that just touch each other (without
/// pressing), equal density, on the plane z = 0. Contacts 0–2: top ball, scale 1; 3–5: ground,
/// `ground_scale` (friction scales, dimensionless).
LimitProblem four_ball_pyramid(double ratio, double ground_scale);

/// Critical μ (dimensionless) of smooth rigid balls, R/r = `ratio`:  sin θ = (2/√3)/(1 + R/r),
/// μ_ball = tan(θ/2), μ_ground = tan(θ/2)/(1 + 3 (r/R)³). Analytic.
struct FourBallThresholds {
  double ball = 0.0;    ///< between the balls
  double ground = 0.0;  ///< on the ground
};
FourBallThresholds four_ball_thresholds(double ratio);

}  // namespace stiction::reference
