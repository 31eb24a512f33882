// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <variant>
#include <vector>

#include "solver/gravity.h"

namespace stiction {

// A problem is physics alone: shapes, masses, materials, loads, duration. How it is discretised is
// an engine's affair. SI units throughout.

/// A box, centred at its body's pose.
struct BoxShape {
  Vec3 size = Vec3::Ones();  ///< edge lengths, m
};

/// A mass without extension.
struct PointShape {};

using Shape = std::variant<BoxShape, PointShape>;

/// Isotropic linear elasticity with strain-rate damping.
struct Elasticity {
  double youngs_modulus = 5e5;  ///< Pa
  double poisson_ratio = 0.3;   ///< dimensionless
  double damping_time = 0.0;    ///< β in s: viscous stress = β · elasticity · strain rate
};

struct ProblemBody {
  std::string name;
  Shape shape;
  double mass = 1.0;  ///< kg, > 0, spread evenly
  Elasticity elasticity;
  Vec3 position = Vec3::Zero();  ///< of the centre of mass, m
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Vec3 velocity = Vec3::Zero();  ///< of every point, m/s
};

/// A fixed half-space: x with (x − point)·normal < 0 is inside.
struct Obstacle {
  std::string name;
  Vec3 point = Vec3::Zero();    ///< m
  Vec3 normal = Vec3::UnitZ();  ///< outward, unit length
  double friction = 0.0;        ///< μ of every pair with this obstacle, dimensionless
};

struct Problem {
  std::string name;
  std::vector<ProblemBody> bodies;
  std::vector<Obstacle> obstacles;
  Gravity gravity;        ///< m/s², constant or ramped
  double duration = 1.0;  ///< s
};

}  // namespace stiction
