// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "solver/mesh/mesh.h"
#include "solver/mesh/topology.h"
#include "solver/real.h"
#include "solver/scene/element_constants.h"
#include "solver/scene/gravity.h"
#include "solver/scene/load.h"
#include "solver/scene/pair_friction.h"

namespace stiction {

/// Isotropic linear elasticity (corotational) with strain-rate damping. SI units.
struct Material {
  double density = 1000.0;      ///< kg/m³, > 0
  double youngs_modulus = 1e6;  ///< Pa, > 0
  double poisson_ratio = 0.3;   ///< dimensionless, in (−1, ½)
  double damping_time = 0.0;  ///< β in s, ≥ 0: viscous stress = β · elasticity · strain rate
};

/// A deformable body, or a point mass (one vertex, no tetrahedra, `point_mass` > 0).
struct BodyDescription {
  std::string name;
  TetMesh mesh;                       ///< initial and rest shape, m
  Material material;                  ///< unused by point masses
  double point_mass = 0.0;            ///< kg, of each vertex that no tetrahedron carries
  Eigen::Matrix3Xd initial_velocity;  ///< 3 × vertex count, m/s; empty means at rest
  std::vector<int> pinned;            ///< vertices that never move, or follow `motion`
  Motion motion{};                    ///< of the pinned vertices
  bool self_collision = false;        ///< its vertices may touch its own tetrahedra
  Eigen::Matrix3d axes =
      Eigen::Matrix3d::Identity();  ///< its own, orthonormal: what they turn leaves its numbering
};

/// A fixed obstacle: the points x with (x − point)·normal < 0 are inside it.
struct HalfSpace {
  std::string name;
  Vec3 point = Vec3::Zero();    ///< any point of the plane, m
  Vec3 normal = Vec3::UnitZ();  ///< outward, unit length
  Real friction = 0.0;          ///< μ against every body, dimensionless, ≥ 0
  Motion motion{};              ///< of the whole half-space
};

/// What a user describes; `build_scene` checks it and turns it into a Scene.
struct SceneDescription {
  std::vector<BodyDescription> bodies;
  std::vector<HalfSpace> half_spaces;
  Gravity gravity;
  Drag drag{};
  Real friction = 0.0;  ///< μ between bodies, dimensionless, ≥ 0
  Real rounding = 0.0;  ///< of the places given, m: bodies may start so deep inside an obstacle
  std::vector<Load> loads{};
  std::vector<Spring> springs{};
  std::vector<PairFriction> pair_friction{};  ///< of pairs that have a μ of their own
};

/// The corners of one tetrahedron.
struct Element {
  std::int32_t vertex[4];  ///< scene vertices
};

/// A body's place in the scene's arrays.
struct Body {
  std::string name;
  int first_vertex = 0;  ///< its vertices are contiguous
  int vertex_count = 0;
  std::size_t surface_begin = 0;  ///< its places in Scene::surface_vertex, to before `surface_end`
  std::size_t surface_end = 0;
  double mass = 0.0;      ///< kg, the sum of its vertices', pinned ones included
  int first_element = 0;  ///< its elements are contiguous
  int element_count = 0;
  bool self_collision = false;
  bool fixed = false;  ///< all its vertices are pinned
  Motion motion{};     ///< of its pinned vertices
};

/// Tells the scenes of one process apart, so that lists which were made for one are not taken for
/// another's. A copy is another scene: it may be edited.
class SceneSerial {
 public:
  SceneSerial() : value_(next()) {}
  SceneSerial(const SceneSerial&) : value_(next()) {}
  SceneSerial(SceneSerial&& other) noexcept : value_(std::exchange(other.value_, next())) {}
  SceneSerial& operator=(const SceneSerial& other) {
    if (this != &other) value_ = next();
    return *this;
  }
  SceneSerial& operator=(SceneSerial&& other) noexcept {
    value_ = std::exchange(other.value_, next());
    return *this;
  }
  operator std::uint64_t() const { return value_; }  ///< > 0

 private:
  static std::uint64_t next();
  std::uint64_t value_;
};

/// Constant data of a simulation. Vertices of a body are renumbered at load: along a space-filling
/// curve, those on the surface first; elements follow their vertices.
struct Scene {
  SceneSerial serial;
  std::vector<Body> bodies;
  std::vector<HalfSpace> half_spaces;
  Gravity gravity;
  Drag drag{};
  Real friction = 0.0;           ///< μ between bodies
  FrictionTable own_friction{};  ///< of pairs that have a μ of their own
  std::vector<Load> loads{};
  std::vector<Spring> springs{};
  Topology topology;  ///< for two-sided contact; empty when no two bodies can touch
  bool pairs_possible = false;
  bool anything_moves_by_plan = false;  ///< a body or half-space has a motion

  Eigen::Matrix3X<Real> rest_position;     ///< 3 × vertex count, m
  Eigen::Matrix3X<Real> initial_velocity;  ///< 3 × vertex count, m/s
  std::vector<Real> mass;                  ///< lumped, per vertex, kg
  std::vector<Real> inverse_mass;          ///< 1/kg, 0 where pinned
  std::vector<int> surface_vertex;         ///< vertices that can touch something, increasing
  std::vector<Element> elements;
  BlocksOfConstants constants;    ///< of the elements
  std::vector<int> scene_vertex;  ///< scene vertex of the k-th described vertex (bodies in order)

  double swing_time = 0.0;        ///< s, the longest of bodies that can move; 0: nothing is elastic
  double stable_time_step = 0.0;  ///< s; infinite when nothing is elastic
  int stiffest_element = -1;      ///< described number, counted over bodies in order
  std::string stiffest_body;      ///< whose element that is

  int vertex_count() const { return static_cast<int>(mass.size()); }
};

/// Checks a description and builds the scene.
/// Throws InputError with one sentence for: NaN or infinite numbers, indices out of range, inverted
/// or zero-volume tetrahedra, tetrahedra whose highest frequency no number holds, vertices without
/// mass, negative density, stiffness, damping or μ, a Poisson ratio outside (−1, ½), normals that
/// are not unit vectors, keyframes out of order, loads of bodies that are not there, and bodies that
/// start inside an obstacle.
Scene build_scene(const SceneDescription& description);

}  // namespace stiction
