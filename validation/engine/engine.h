// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "reports/record/record.h"
#include "validation/engine/problem.h"
#include "validation/judge/expectation.h"

namespace stiction {

/// Settings of an engine, by name; unknown names and unreadable values are refused in words.
using Settings = std::map<std::string, std::string>;

/// What a case may ask of an engine.
struct Capabilities {
  bool deformable = false;  ///< boxes deform; else they are rigid
  bool point_masses = false;
  bool save_restore = false;
};

/// Centre-of-mass motion of one body.
struct BodyMotion {
  Vec3 position;  ///< m
  Vec3 velocity;  ///< m/s
  /// Rotation from the initial pose that fits the body best (mass-weighted).
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
};

struct Momenta {
  Vec3 linear;   ///< kg m/s
  Vec3 angular;  ///< about the origin, kg m²/s
};

/// One contact point at the end of a step, as an outside evaluator sees it.
struct ContactSample {
  std::size_t body = 0;
  std::size_t obstacle = 0;  ///< touched: an obstacle, or another body with `against_body`
  bool against_body = false;
  std::int64_t point = 0;   ///< the engine's stable number for the touching point
  std::int64_t facet = -1;  ///< and for the facet that it touches; −1: it has none, or won't tell
  Vec3 normal;              ///< out of the obstacle, unit
  double gap = 0.0;         ///< m
  double normal_force = 0.0;     ///< N, ≥ 0
  Vec3 friction_force;           ///< on the body, N
  Vec3 slip;                     ///< tangential velocity over the obstacle, m/s
  bool sticks = false;           ///< the engine's own word
  Vec3 position = Vec3::Zero();  ///< of the point, m
  /// From where the reaction acts to where the force does, at the start of the last step, m. Times
  /// the force it is what the contact adds to the angular momentum.
  Vec3 arm = Vec3::Zero();
};

struct Energies {
  double kinetic = 0.0;  ///< J
  double gravity = 0.0;  ///< J, zero level arbitrary but fixed
  double elastic = 0.0;  ///< J
};

/// An opaque copy of an engine's whole state, friction memory included.
using Snapshot = std::shared_ptr<const void>;

/// The adapter behind which any engine can be put. One object simulates one problem.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Takes the problem and stands at time 0. Throws InputError for what it cannot simulate.
  virtual void load(const Problem& problem) = 0;

  virtual double time_step() const = 0;           ///< Δt, s; after load
  virtual std::uint64_t steps_done() const = 0;   ///< t = steps · Δt
  virtual void advance(std::uint64_t steps) = 0;  ///< whole steps; throws InputError if it diverges

  virtual BodyMotion body(std::size_t index) const = 0;
  virtual std::vector<ContactSample> contacts() const = 0;
  /// For pictures: triangles of a body's surface, counter-clockwise seen from outside, and where
  /// the vertices that they name are now (m). Empty, the default: nothing to draw.
  virtual Eigen::Matrix3Xi surface(std::size_t) const { return {}; }
  virtual Eigen::Matrix3Xd vertices(std::size_t) const { return {}; }

  virtual Energies energies() const = 0;
  virtual Momenta momenta() const = 0;

  virtual std::vector<Mesh> meshes() const { return {}; }  ///< bodies of one mesh only once
  virtual Settings settings() const = 0;                   ///< as resolved, Δt included
  virtual Cost cost() const = 0;                           ///< of all steps so far
  virtual std::uint64_t state_hash() const = 0;
  virtual Snapshot save() const = 0;
  virtual void restore(const Snapshot& snapshot) = 0;
};

/// A maker of engines: what a file in validation/engines/ returns from `engine_<file>()`.
struct EngineKind {
  std::string name;
  std::string description;  ///< one line
  Capabilities capabilities;
  std::map<std::string, std::string> settings_help;  ///< name → meaning, unit, default
  std::unique_ptr<Engine> (*make)(const Settings& settings);
  Expectations expectations{};  ///< where the engine is known to fall short, and how far
};

/// All engines of the build, by name. Written by the build from validation/engines/.
std::vector<EngineKind> engine_catalog();

/// Throws InputError naming the engines there are.
EngineKind find_engine(const std::string& name);

}  // namespace stiction
