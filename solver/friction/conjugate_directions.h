// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "solver/friction/chunks_of_side.h"
#include "solver/lanes/packed_vec3.h"
#include "solver/state.h"
#include "solver/workspace.h"

namespace stiction {

// A record as a vector of either kind, and back; a packed one takes or leaves the fourth number.
template <class Vector>
STICTION_LANES_INLINE Vector got(const ForceChange& record) {
  if constexpr (std::is_same_v<Vector, PackedVec3>) {
    return PackedVec3::load(&record);
  } else {
    return record.force;
  }
}
STICTION_LANES_INLINE void put(const PackedVec3& force, ForceChange& record) {
  force.store(&record);
}
inline void put(const Vec3& force, ForceChange& record) { record.force = force; }

/// Conjugate directions over the sweeps of one step (see conjugate_vector.h), for the contacts of
/// one kind. `Side` gives access to them, as in sides.h.
template <class Side>
class ConjugateSide {
 public:
  ConjugateSide(const Side& side, ConjugateScratch& scratch, const Team* team,
                std::span<Velocity> velocity)
      : side_(side), scratch_(scratch), team_(team), velocity_(velocity) {
    scratch_.change.resize(side.size());
  }

  /// Before a sweep, whose changes are to be added to `all`.
  void begin(SweepChange& all) {
    all_ = &all;
    if (!alone()) scratch_.of_chunk.assign(side_.order.chunks(), {});
  }

  /// Of the k-th chunk: before it, for each of its contacts, behind it. Its sum is in the order of the
  /// contacts, wherever they stand. One chunk goes on with the sum of the sides before it, several
  /// begin anew, for they may be done side by side.
  void start(std::size_t k) { sum_ = alone() ? *all_ : scratch_.of_chunk[k]; }
  template <class Vector>
  STICTION_LANES_INLINE void add(std::size_t c, const Vector& change) {
    const Real weight = side_.inverse_mass(c, velocity_);
    const Real power = weight * change.squaredNorm();
    put(change, scratch_.change[c]);
    if constexpr (Side::kInOrder) {
      sum_.power += power;
    } else {
      scratch_.change[c].power = power;
    }
    sum_.slip2 = std::max(sum_.slip2, weight * power);
  }
  void finish(std::size_t k, const ContactOrder::Chunk& chunk) {
    if constexpr (!Side::kInOrder) {
      for (const std::int32_t c : side_.order.in_turn(chunk)) {
        sum_.power += scratch_.change[static_cast<std::size_t>(c)].power;
      }
    }
    (alone() ? *all_ : scratch_.of_chunk[k]) = sum_;
  }

  /// After the sweep.
  void end() {
    if (alone()) return;
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
    using Vector = typename Side::Vector;
    const auto of_chunk = [&](std::size_t, const ContactOrder::Chunk& chunk)
        __attribute__((always_inline)) {
      // Copies, of which the compiler knows that nothing else changes them.
      const Side side = side_;
      const Real factor = beta;
      const std::span<Velocity> velocity = velocity_;
      ForceChange* const direction = scratch_.direction.data();
      const ForceChange* const change = scratch_.change.data();
      const auto [begin, end] = chunk;
      for (std::size_t place = begin; place < end; ++place) {
        side.ask_ahead(place, velocity);
        const std::size_t c = side.contact(place);
        const Vector force = side.force(c);
        const Vector step = factor * got<Vector>(direction[c]);
        put(step + got<Vector>(change[c]), direction[c]);
        Vector wanted = force + step;
        const Real bound = side.bound(c);
        const Real size2 = wanted.squaredNorm();
        if (size2 > bound * bound) wanted *= bound / std::sqrt(size2);
        auto held = side.held(c, velocity);
        side.push(wanted - force, held);
        side.set_force(c, wanted);
      }
    };
    friction_phase::for_each_chunk(side_, team_, of_chunk);
  }

 private:
  bool alone() const { return side_.order.chunks() <= 1; }

  const Side& side_;
  SweepChange* all_ = nullptr;
  SweepChange sum_;  // of the chunk that a copy hears of
  ConjugateScratch& scratch_;
  const Team* team_;
  std::span<Velocity> velocity_;
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
