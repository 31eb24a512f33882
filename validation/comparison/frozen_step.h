// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "solver/options.h"
#include "solver/scene/scene.h"
#include "solver/state.h"
#include "solver/workspace.h"
#include "validation/comparison/scenes.h"

namespace stiction {

/// The paper's system (15), u(ξ) = 0, on one step of a settled scene that is replayed as often as
/// one likes from the same state: contacts, normal forces and start velocities are frozen, only
/// what friction remembers changes. The cone is left out (μ is raised a hundredfold), because (15)
/// is about static contacts only. Unknown are the N contacts under load that were there before the
/// step; those of obstacles are not part of it.
class FrozenStep {
 public:
  /// Settles on the contacts of `method` (and forgets, see settled_without_memory), then lets the
  /// fixed point learn for 200 steps.
  FrozenStep(const EngineKind& kind, const ComparisonScene& scene, const std::string& method);

  Eigen::Index contacts() const { return static_cast<Eigen::Index>(place_.size()); }

  /// What the fixed point had learned, N values, dimensionless.
  Eigen::VectorXd learned() const;

  /// Slip at the end of the step with ξ prescribed, along ũ and across it: N values each, m/s.
  struct Slip {
    Eigen::VectorXd along, across;
    Eigen::VectorXd free;  ///< |ũ|, m/s
  };
  Slip slip_with(const Eigen::VectorXd& xi) const;

  /// Slip with a tangential bias c prescribed (bias-vector), in a fixed basis of each contact's
  /// tangent plane: 2N values of 2N unknowns, m/s.
  Eigen::VectorXd slip_with_bias(const Eigen::VectorXd& bias) const;

 private:
  void replay(const char* rule, const std::vector<double>& memory) const;
  Vec3 slip_of(const PairContact& contact) const;

  Scene scene_;
  Options options_;
  State start_;
  std::vector<std::size_t> place_;  // of each unknown's contact in the memory of `start_`
  mutable State state_;
  mutable Workspace workspace_;
};

}  // namespace stiction
