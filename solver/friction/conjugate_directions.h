// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "solver/state.h"
#include "solver/workspace.h"

namespace stiction {

/// Conjugate directions over the sweeps of one step (see conjugate_vector.h), for the contacts of
/// one kind. `Side` gives access to them, as in friction.cpp.
template <class Side>
class ConjugateSide {
 public:
  ConjugateSide(const Side& side, ConjugateScratch& scratch, const Team* team,
                std::vector<Velocity>& velocity)
      : side_(side), scratch_(scratch), team_(team), velocity_(velocity) {
    scratch_.change.resize(side.size());
  }

  /// Before a sweep, whose changes are to be added to `all`.
  void begin(SweepChange& all) {
    all_ = &all;
    scratch_.of_chunk.assign(side_.order.chunks(), {});
  }

  /// Of the k-th chunk: before it, for each of its contacts, behind it. One chunk goes on with the sum
  /// of the sides before it, several begin anew, for they may be done side by side.
  SweepChange start(std::size_t) const {
    return scratch_.of_chunk.size() == 1 ? *all_ : SweepChange{};
  }
  void add(std::size_t c, const Vec3& change, SweepChange& sum) {
    scratch_.change[c] = change;
    const Real weight = side_.inverse_mass(c, velocity_);
    const Real power = weight * change.squaredNorm();
    sum.power += power;
    sum.slip2 = std::max(sum.slip2, weight * power);
  }
  void finish(std::size_t k, const SweepChange& sum) {
    (scratch_.of_chunk.size() == 1 ? *all_ : scratch_.of_chunk[k]) = sum;
  }

  /// After the sweep.
  void end() {
    if (scratch_.of_chunk.size() == 1) return;
    for (const SweepChange& chunk : scratch_.of_chunk) {
      all_->power += chunk.power;
      all_->slip2 = std::max(all_->slip2, chunk.slip2);
    }
  }

  /// p ← r.
  void restart() {
    std::swap(scratch_.direction, scratch_.change);
    scratch_.change.resize(side_.size());
  }

  /// f ← P(f + β p), p ← β p + r.
  void accelerate(Real beta) {
    side_.order.for_each_chunk(team_, [&](std::size_t, const ContactOrder::Chunk& chunk) {
      // Copies, of which the compiler knows that nothing else changes them.
      const Side side = side_;
      Vec3* const direction = scratch_.direction.data();
      const Vec3* const change = scratch_.change.data();
      for (std::size_t c = chunk.begin; c < chunk.end; ++c) {
        const Vec3 force = side.force(c);
        const Vec3 step = beta * direction[c];
        direction[c] = step + change[c];
        Vec3 wanted = force + step;
        const Real bound = side.bound(c);
        const Real size2 = wanted.squaredNorm();
        if (size2 > bound * bound) wanted *= bound / std::sqrt(size2);
        side.apply(c, wanted - force, velocity_);
        side.force(c) = wanted;
      }
    });
  }

 private:
  const Side& side_;
  SweepChange* all_ = nullptr;
  ConjugateScratch& scratch_;
  const Team* team_;
  std::vector<Velocity>& velocity_;
};

/// Sweeps at most `sweeps` times, accelerating in between, until a sweep takes away no more slip
/// than `tolerance` (m/s) from any contact, or eight sweeps have taken less than a tenth off what a
/// sweep still changes: where contacts slide, directions are cut off at their cones, slip creeps on
/// by 0.2 % a sweep (measured in a row of boxes at its critical force), and 64 would halve nothing.
/// `sweep(first, sides…)` does one, of whose changes each side hears. Returns the sweeps done. All
/// sides share one β.
template <class Sweep, class... Sides>
int conjugate_sweeps(int sweeps, Real tolerance, const Sweep& sweep, Sides&... side) {
  constexpr int kPatience = 8;
  constexpr Real kWorthIt = 0.81;  // of the power, the square of what is changed
  Real last = 0.0;                 // no direction yet
  Real mark = std::numeric_limits<Real>::infinity();
  for (int s = 1;; ++s) {
    SweepChange change;
    (side.begin(change), ...);
    sweep(s == 1, side...);
    (side.end(), ...);
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
