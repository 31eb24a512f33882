// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "reports/record/record.h"
#include "validation/engine/problem.h"
#include "validation/judge/expectation.h"

namespace stiction {

/// Settings of an engine, by name; unknown names and unreadable values are refused in words.
using Settings = std::map<std::string, std::string>;

/// What an engine has. missing() holds a problem against it.
struct Manifest {
  bool point_masses = false;
  bool boxes = false;
  bool balls = false;
  bool meshes = false;         ///< bodies of any shape, given as tetrahedra
  bool convex_meshes = false;  ///< … of any convex shape
  bool deformable = false;     ///< bodies deform; else they are rigid
  bool held_parts = false;     ///< parts of a body that are held, or moved
  bool body_contact = false;   ///< bodies touch each other
  bool self_contact = false;   ///< … and themselves
  bool moving_obstacles = false;
  bool steady_motion = false;    ///< of held parts and obstacles: Motion::velocity
  bool oscillation = false;      ///< of supports, loads and gravity: a sine over time
  bool pair_friction = false;    ///< μ of single pairs
  bool restitution = false;      ///< of contacts
  bool drag = false;             ///< a medium that damps all motion
  bool varying_gravity = false;  ///< over time
  bool loads = false;            ///< forces, couples and springs on bodies
  bool spin = false;             ///< bodies turn
  bool contacts = false;         ///< contacts() tells them
  bool snapshots = false;        ///< save() and restore()
};

/// Centre-of-mass motion of one body.
struct BodyMotion {
  Eigen::Vector3d position;  ///< m
  Eigen::Vector3d velocity;  ///< m/s
  /// Rotation from the initial pose that fits the body best (mass-weighted).
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  /// Of the rigid motion with the body's angular momentum about its centre, rad/s.
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();
};

struct Momenta {
  Eigen::Vector3d linear;   ///< kg m/s
  Eigen::Vector3d angular;  ///< about the origin, kg m²/s
};

/// One contact point at the end of a step, as an outside evaluator sees it.
struct ContactSample {
  std::size_t body = 0;
  std::size_t obstacle = 0;  ///< touched: an obstacle, or another body with `against_body`
  bool against_body = false;
  std::int64_t point = 0;   ///< the engine's stable number for the touching point
  std::int64_t facet = -1;  ///< and for the facet that it touches; −1: it has none, or won't tell
  Eigen::Vector3d normal;   ///< out of the obstacle, unit
  double gap = 0.0;         ///< m
  double normal_force = 0.0;       ///< N, ≥ 0
  Eigen::Vector3d friction_force;  ///< on the body, N
  Eigen::Vector3d slip;            ///< tangential velocity over the obstacle, m/s
  bool sticks = false;             ///< the engine's own word
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of the point, m
  /// From where the reaction acts to where the force does, at the start of the last step, m. Times
  /// the force it is what the contact adds to the angular momentum.
  Eigen::Vector3d arm = Eigen::Vector3d::Zero();
};

struct Energies {
  double kinetic = 0.0;  ///< J
  double gravity = 0.0;  ///< J, zero level arbitrary but fixed
  double elastic = 0.0;  ///< J
};

/// An opaque copy of an engine's whole state, friction memory included.
using Snapshot = std::shared_ptr<const void>;

/// The engine lacks what a case needs: the record is `not applicable`, with these words.
class NotApplicable : public std::runtime_error {
 public:
  explicit NotApplicable(const std::string& words) : std::runtime_error(words) {}
};

/// The adapter behind which any engine can be put. One object simulates one problem.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Takes the problem and stands at time 0. Throws InputError for what it cannot simulate.
  virtual void load(const Problem& problem, const Accuracy& accuracy) = 0;

  virtual double time_step() const = 0;           ///< Δt, s; after load
  virtual std::uint64_t steps_done() const = 0;   ///< t = steps · Δt
  virtual void advance(std::uint64_t steps) = 0;  ///< whole steps; throws InputError if it diverges
  /// Its word, after load: each step takes the velocities on by Δt times the acceleration at its
  /// start, then the positions by Δt times the new velocities. Cases then hold it to that
  /// recurrence, to round-off; any engine is held to the truncation error of first order.
  virtual bool symplectic_euler() const { return false; }

  virtual BodyMotion body(std::size_t index) const = 0;
  /// Those at the end of the last step. An engine that does not tell them leaves this out: a case
  /// that asks is not applicable. Manifest::contacts says which.
  virtual std::vector<ContactSample> contacts() const {
    throw NotApplicable("the engine does not tell its contacts");
  }
  /// For pictures: triangles of a body's surface, counter-clockwise seen from outside, and where
  /// the vertices that they name are now (m). Empty, the default: nothing to draw.
  virtual Eigen::Matrix3Xi surface(std::size_t) const { return {}; }
  virtual Eigen::Matrix3Xd vertices(std::size_t) const { return {}; }

  virtual Energies energies() const = 0;
  /// `energies().kinetic`, for who asks often.
  virtual double kinetic_energy() const { return energies().kinetic; }
  virtual Momenta momenta() const = 0;

  virtual std::vector<Mesh> meshes() const { return {}; }  ///< bodies of one mesh only once
  /// Elements along the longest edge of a box, of those that it is resolved into; 0: none.
  virtual int fineness() const { return 0; }
  virtual Settings settings() const = 0;  ///< as resolved, Δt included
  virtual Cost cost() const = 0;          ///< of all steps so far
  /// `cost().cpu_seconds`, for who asks after each step.
  virtual double cpu_seconds() const { return cost().cpu_seconds; }
  virtual std::uint64_t state_hash() const = 0;
  /// With Manifest::snapshots alone.
  virtual Snapshot save() const { throw NotApplicable("the engine has no snapshots"); }
  virtual void restore(const Snapshot&) { throw NotApplicable("the engine has no snapshots"); }
};

/// A way to run an engine that it brings with it.
struct Configuration {
  Settings settings{};
  std::string name{};    ///< "default", "best", "paper, secant"; may be empty
  std::string source{};  ///< where the values come from; may be empty
  /// It stands for a method that is known to break: beside an expectation nothing of it is judged,
  /// and bodies that pass through each other are a note in the record, not an error.
  bool contrast = false;
  /// Bodies pass through each other where they part or are thrown together. Where a case does that
  /// (CaseRun::bodies_are_thrown) it is a note.
  bool lets_thrown_pass = false;
  /// Its word: every reaction acts where the force does, so that angular momentum is exact.
  bool keeps_angular_momentum = false;
  bool only_full = false;  ///< it runs with --full alone
};

/// What a case may ask an engine to leave out, for contrast.
enum class Without {
  kFrictionMemory,  ///< of one step's friction in the next
  kPostCorrection,  ///< reactions on what a body touches
  kStabilisation,   ///< [Lazarevych2009]'s method with ξ = 1, whatever the run's own is
};

struct Case;

/// A maker of engines: what the folder validation/engines/<name>/ returns from `engine_<name>()`, or
/// a program says of itself (program_kind.h).
struct EngineKind {
  std::string name;
  std::string description;  ///< one line
  std::string program{};    ///< the command that starts it; empty: it is of this build
  Manifest manifest;
  std::map<std::string, std::string> settings_help;  ///< name → meaning, unit, default
  std::function<std::unique_ptr<Engine>(const Settings& settings)> make;
  Expectations expectations{};  ///< where the engine is known to fall short, and how far
  /// With what it runs a case by default, by the case's name; null: once, without settings.
  std::function<std::vector<Configuration>(const std::string& case_name)> configurations{};
  /// What of the run of these settings is judged how, and the name and settings of the configuration
  /// that they are, or are nearest to; null: all, strictly.
  std::function<Configuration(const Settings& settings)> configuration{};
  /// Those of the settings that have no effect beside the others, each with a sentence that says
  /// why; null: all have. A run whose user gives such a one is refused, unless some of its jobs use
  /// it.
  std::function<std::map<std::string, std::string>(const Settings& settings)> idle{};
  /// Settings, over a run's own, that leave something out; null or none: the engine can't.
  std::function<std::optional<Settings>(Without what)> without{};
  std::function<std::vector<Case>()> studies{};  ///< cases about this engine alone; null: none
  /// Other builds of it, and the engines that they are: "single", of single precision, "fused", with
  /// contraction.
  std::map<std::string, std::string> builds{};
  /// Efforts from the usual to the most, each laid over a configuration: smaller steps, more
  /// iterations. A work-precision curve has a point at each. Empty: the usual alone.
  std::vector<Settings> ladder{};
};

/// What people call a run with these settings, and which of them go beyond that: the name that the
/// engine gives them, else that of its configuration with the most settings of which all are among
/// them, else "default".
struct CalledConfiguration {
  std::string name;
  Settings differs{};
};
CalledConfiguration called_configuration(const EngineKind& kind, const std::string& case_name,
                                         const Settings& settings);

/// What the engine lacks for a problem, in words: "bodies that deform, a medium"; empty: nothing.
std::string missing(const Manifest& manifest, const Problem& problem);

/// All engines of the build, by name. Written by the build from validation/engines/.
std::vector<EngineKind> engine_catalog();

/// One of the build's, or a program: `words` is a name, or a command (program_kind.h). Throws
/// InputError naming the engines there are.
EngineKind find_engine(const std::string& words);

}  // namespace stiction
