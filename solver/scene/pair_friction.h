// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/real.h"

namespace stiction {

/// μ of one pair, in place of what holds for all bodies, or for all against that obstacle.
struct PairFriction {
  std::size_t body = 0;
  std::size_t other = 0;  ///< a half-space, or another body with `against_body`
  bool against_body = false;
  double friction = 0.0;  ///< dimensionless, ≥ 0
};

/// μ by vertices, for scenes in which pairs have one of their own.
class FrictionTable {
 public:
  /// No pair has one of its own.
  bool empty() const { return mu_.empty(); }
  /// `body_of_vertex` of each scene vertex; the pairs were checked.
  void make(std::vector<std::int32_t> body_of_vertex, std::size_t bodies, Real between_bodies,
            const std::vector<Real>& against_obstacles, const std::vector<PairFriction>& pairs);

  /// Between the bodies of two vertices.
  Real between(std::int32_t vertex, std::int32_t other) const {
    return mu(vertex, static_cast<std::size_t>(body_[static_cast<std::size_t>(other)]));
  }
  Real against_obstacle(std::int32_t vertex, std::int32_t obstacle) const {
    return mu(vertex, bodies_ + static_cast<std::size_t>(obstacle));
  }

 private:
  Real mu(std::int32_t vertex, std::size_t column) const {
    return mu_[static_cast<std::size_t>(body_[static_cast<std::size_t>(vertex)]) * columns_ +
               column];
  }

  std::vector<std::int32_t> body_{};
  std::vector<Real> mu_{};  // a row a body: against bodies, then against half-spaces
  std::size_t bodies_ = 0, columns_ = 0;
};

}  // namespace stiction
