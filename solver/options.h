// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "solver/contact/pair_options.h"
#include "solver/friction/parameter.h"
#include "solver/scene/scene.h"

namespace stiction {

/// How velocities are placed in time.
enum class Integrator {
  kSymplecticEuler,  ///< velocities at the ends of steps; positions of first order
  kVerlet  ///< Störmer–Verlet: velocities half a step behind; positions of second order
};

/// How a scene is stepped: what a user may turn without changing the physics described.
struct Options {
  double time_step = 2e-4;                ///< Δt, s
  std::string rule = "conjugate-vector";  ///< friction rule: a file of solver/friction/rules/
  RuleSettings friction{};  ///< parameters of that rule which are not at their defaults, by name
  Integrator integrator = Integrator::kSymplecticEuler;
  /// Passes over all contacts in the friction phase, ≥ 1; 0: as many as the rule's card says. A
  /// rule with conjugate directions ends them as soon as its slip tolerance is met.
  int sweeps = 0;
  PairOptions pairs{};  ///< two-sided contacts

  /// Δt as forces and velocities are multiplied by it; times are reckoned with `time_step`.
  Real dt() const { return static_cast<Real>(time_step); }
};

/// Throws InputError with one sentence when an option is out of range or unknown, whatever the
/// scene.
void check_options(const Options& options);

/// … or when Δt is above the scene's element stability limit (the sentence names the limit and the
/// element), or too long for its drag.
void check_options(const Options& options, const Scene& scene);

}  // namespace stiction
