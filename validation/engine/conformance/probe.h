// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "validation/engine/conformance/conformance.h"

namespace stiction {

/// What an adapter's answer says against it, in one sentence.
class Nonconformity : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Starts the engine under test on small problems.
class Probe {
 public:
  Probe(const EngineKind& kind, const Settings& settings) : kind_(kind), settings_(settings) {}

  const Manifest& manifest() const { return kind_.manifest; }
  /// A body that the engine takes, of 2 kg, 0.2 × 0.16 × 0.1 m or as large, at the origin.
  ProblemBody body(const std::string& name) const;
  /// Throws NotApplicable for what the engine lacks.
  std::unique_ptr<Engine> start(const Problem& problem, const Accuracy& accuracy = {}) const;
  /// Throws NotApplicable with these words where the engine has not got the feature.
  void need(bool has, const std::string& words) const;

 private:
  const EngineKind& kind_;
  const Settings& settings_;
};

/// From the centre of a body that stands upright down to what it stands on, m.
double half_height(const ProblemBody& body);

/// Takes the engine to this time, to the nearest step, and returns the time reached, s.
double advance_to(Engine& engine, double time);

// The checks. Each returns what it saw, and throws Nonconformity.
std::string check_start(const Probe& probe);
std::string check_velocity(const Probe& probe);
std::string check_free_fall(const Probe& probe);
std::string check_spin(const Probe& probe);
std::string check_loads(const Probe& probe);
std::string check_sines(const Probe& probe);
std::string check_weight(const Probe& probe);
std::string check_friction(const Probe& probe);
std::string check_pair_friction(const Probe& probe);
std::string check_single_pairs(const Probe& probe);
std::string check_restitution(const Probe& probe);
std::string check_snapshots(const Probe& probe);
std::string check_repeats(const Probe& probe);
std::string check_finer(const Probe& probe);

}  // namespace stiction
