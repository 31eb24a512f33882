// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "solver/state.h"
#include "solver/workspace.h"

namespace stiction {

/// What a sweep changed.
struct SweepChange {
  Real power = 0.0;  ///< Σ w |r|², r the change of a contact's force, W
  Real slip2 = 0.0;  ///< max (w |r|)², m²/s²: the slip that the sweep took away, squared
};

/// Conjugate directions over the sweeps of one step (see conjugate_vector.h), for the contacts of
/// one kind. `Side` gives access to them, as in friction.cpp.
template <class Side>
class ConjugateSide {
 public:
  ConjugateSide(const Side& side, ConjugateScratch& scratch, std::vector<Velocity>& velocity)
      : side_(side), scratch_(scratch), velocity_(velocity) {
    scratch_.change.resize(side.size());
  }

  /// Hears from a sweep what it did to a contact.
  void changed(std::size_t c, const Vec3& change, SweepChange& all) {
    scratch_.change[c] = change;
    const Real weight = side_.inverse_mass(c, velocity_);
    const Real power = weight * change.squaredNorm();
    all.power += power;
    all.slip2 = std::max(all.slip2, weight * power);
  }

  /// p ← r.
  void restart() { scratch_.direction = scratch_.change; }

  /// f ← P(f + β p), p ← β p + r.
  void accelerate(Real beta) {
    for (std::size_t c = 0; c < side_.size(); ++c) {
      const Vec3 force = side_.force(c);
      const Vec3 step = beta * scratch_.direction[c];
      scratch_.direction[c] = step + scratch_.change[c];
      Vec3 wanted = force + step;
      const Real bound = side_.bound(c);
      const Real size2 = wanted.squaredNorm();
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
/// than `tolerance` (m/s) from any contact, or eight sweeps have taken less than a tenth off what a
/// sweep still changes: where contacts slide, directions are cut off at their cones, slip creeps on
/// by 0.2 % a sweep (measured in a row of boxes at its critical force), and 64 would halve nothing.
/// `sweep(first, changed…)` does one and tells the n-th of `changed` of the n-th side. Returns the
/// sweeps done. All sides share one β.
template <class Sweep, class... Sides>
int conjugate_sweeps(int sweeps, Real tolerance, const Sweep& sweep, Sides&... side) {
  constexpr int kPatience = 8;
  constexpr Real kWorthIt = 0.81;  // of the power, the square of what is changed
  Real last = 0.0;                 // no direction yet
  Real mark = std::numeric_limits<Real>::infinity();
  for (int s = 1;; ++s) {
    SweepChange change;
    sweep(s == 1,
          [&side, &change](std::size_t c, const Vec3& r) { side.changed(c, r, change); }...);
    if (s == sweeps || change.slip2 <= tolerance * tolerance) return s;
    if (s % kPatience == 0) {
      if (change.power > kWorthIt * mark) return s;
      mark = change.power;
    }
    if (s > 1 && change.power <= last) {
      const Real beta = change.power / last;
      (side.accelerate(beta), ...);
    } else {
      (side.restart(), ...);
    }
    last = change.power;
  }
}

}  // namespace stiction
