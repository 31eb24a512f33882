// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/state.h"
#include "solver/workspace.h"

namespace stiction {

/// What a sweep changed.
struct SweepChange {
  double power = 0.0;  ///< Σ w |r|², r the change of a contact's force, W
  double slip = 0.0;   ///< max w |r|, m/s: the slip that the sweep took away
};

/// Conjugate directions over the sweeps of one step (see conjugate_vector.h), for the contacts of
/// one kind. `Side` gives access to them, as in friction.cpp.
template <class Side>
class ConjugateSide {
 public:
  ConjugateSide(const Side& side, ConjugateScratch& scratch, std::vector<Velocity>& velocity)
      : side_(side), scratch_(scratch), velocity_(velocity) {
    scratch_.before.resize(side.size());
    scratch_.direction.assign(side.size(), Vec3::Zero());
  }

  void before_sweep() {
    for (std::size_t c = 0; c < side_.size(); ++c) scratch_.before[c] = side_.force(c);
  }

  void add_change(SweepChange& change) const {
    for (std::size_t c = 0; c < side_.size(); ++c) {
      const double size = (side_.force(c) - scratch_.before[c]).norm();
      const double slip = side_.inverse_mass(c, velocity_) * size;
      change.power += slip * size;
      change.slip = std::max(change.slip, slip);
    }
  }

  /// f ← P(f + β p), p ← β p + r.
  void accelerate(double beta) {
    for (std::size_t c = 0; c < side_.size(); ++c) {
      const Vec3 force = side_.force(c);
      const Vec3 step = beta * scratch_.direction[c];
      scratch_.direction[c] = step + (force - scratch_.before[c]);
      if (beta == 0.0) continue;
      Vec3 wanted = force + step;
      const double bound = side_.bound(c);
      const double size2 = wanted.squaredNorm();
      if (size2 > bound * bound) wanted *= bound / std::sqrt(size2);
      side_.apply(c, wanted - force, velocity_);
      side_.force(c) = wanted;
    }
  }

 private:
  const Side& side_;
  ConjugateScratch& scratch_;
  std::vector<Velocity>& velocity_;
};

/// Sweeps at most `sweeps` times, accelerating in between, until a sweep takes away no more slip
/// than `tolerance` (m/s). `sweep(first)` does one. Returns the sweeps done. All sides share one β.
template <class Sweep, class... Sides>
int conjugate_sweeps(int sweeps, double tolerance, const Sweep& sweep, Sides&... side) {
  double last = 0.0;  // no direction yet: β = 0
  for (int s = 0; s + 1 < sweeps; ++s) {
    (side.before_sweep(), ...);
    sweep(s == 0);
    SweepChange change;
    (side.add_change(change), ...);
    if (change.slip <= tolerance) return s + 1;
    const double beta = change.power <= last ? change.power / last : 0.0;
    (side.accelerate(beta), ...);
    last = change.power;
  }
  sweep(sweeps == 1);
  return sweeps;
}

}  // namespace stiction
