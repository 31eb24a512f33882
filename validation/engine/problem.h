// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "solver/mesh/mesh.h"
#include "solver/scene/gravity.h"
#include "solver/scene/load.h"
#include "solver/scene/pair_friction.h"

namespace stiction {

// A problem is physics alone: shapes, masses, materials, loads, duration. How it is discretised is
// an engine's affair, and so is its precision: here all is double. SI units throughout.

/// A box, centred at its body's pose.
struct BoxShape {
  Eigen::Vector3d size = Eigen::Vector3d::Ones();  ///< edge lengths, m
};

/// A ball, centred at its body's pose. Which of its facets lie below, where an engine triangulates
/// it, follows from the body's rotation.
struct BallShape {
  double radius = 1.0;  ///< m
};

/// Any volume, given as tetrahedra about the centre of mass: for shapes without a formula.
struct MeshShape {
  TetMesh mesh;         ///< m
  bool convex = false;  ///< it is the convex hull of its vertices
};

/// A mass without extension.
struct PointShape {};

using Shape = std::variant<BoxShape, PointShape, BallShape, MeshShape>;

/// Of the box around it that its own axes span, m; 0 for a point.
double longest_edge(const Shape& shape);

/// Isotropic linear elasticity with strain-rate damping.
struct Elasticity {
  double youngs_modulus = 5e5;  ///< Pa
  double poisson_ratio = 0.3;   ///< dimensionless
  double damping_time = 0.0;    ///< β in s: viscous stress = β · elasticity · strain rate
};

/// A part of a body that is held: its points x (in the body's own frame) with (x − point)·normal ≤
/// 0.
struct HeldPart {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< m
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< any length but 0
};

struct ProblemBody {
  std::string name;
  Shape shape;
  double mass = 1.0;  ///< kg, > 0, spread evenly
  Elasticity elasticity;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of the centre of mass, m
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          ///< of the centre of mass, m/s
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< about it, rad/s
  std::optional<HeldPart> held{};                              ///< fixed, or moved by `motion`
  Motion motion{};                                             ///< of the held part
  bool self_collision = false;                                 ///< it may touch itself
  bool must_deform = false;  ///< what is claimed of it is not true of a rigid body
};

/// A fixed half-space: x with (x − point)·normal < 0 is inside.
struct Obstacle {
  std::string name;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< m
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< outward, unit length
  double friction = 0.0;  ///< μ of every pair with this obstacle, dimensionless
  Motion motion{};        ///< of the whole half-space
};

struct Problem {
  std::string name;
  std::vector<ProblemBody> bodies;
  std::vector<Obstacle> obstacles;
  Gravity gravity;                            ///< m/s², constant or ramped
  Drag drag{};                                ///< while the scene settles
  std::vector<Load> loads{};                  ///< forces and couples on bodies
  std::vector<Spring> springs{};              ///< from bodies to anchors
  double friction = 0.0;                      ///< μ between bodies, dimensionless
  std::vector<PairFriction> pair_friction{};  ///< of pairs that have a μ of their own
  /// e of every contact, dimensionless, 0 … 1: a point that meets another at a normal velocity v
  /// leaves it at e v. At 0 nothing is asked: bodies that deform rebound by their elasticity.
  double restitution = 0.0;
  double duration = 1.0;  ///< s
};

/// Where the bodies are at the start, m, about as their size; empty without any.
Eigen::AlignedBox3d bounds_of(const Problem& problem);

/// How finely a case needs its problem resolved. An engine makes of it what it has: a mesh, a time
/// step. What a user sets by hand goes before `fineness` and `time`, never before `finer`.
struct Accuracy {
  int fineness = 0;   ///< a body's longest edge over what it is resolved to; 0: the engine's choice
  int roundness = 0;  ///< points on a ball's surface, at least; 0: the engine's choice
  double time = 0.0;  ///< s: what lasts so long is resolved; 0: the engine's choice
  double finer = 1.0;  ///< time is resolved so many times more finely than all that comes to
};

}  // namespace stiction
