// SPDX-License-Identifier: BSD-3-Clause
#include "solver/scene/pair_friction.h"

#include <algorithm>
#include <utility>

namespace stiction {

void FrictionTable::make(std::vector<std::int32_t> body_of_vertex, std::size_t bodies,
                         Real between_bodies, const std::vector<Real>& against_obstacles,
                         const std::vector<PairFriction>& pairs) {
  if (pairs.empty()) return;
  body_ = std::move(body_of_vertex);
  bodies_ = bodies;
  columns_ = bodies + against_obstacles.size();
  mu_.assign(bodies * columns_, between_bodies);
  for (std::size_t b = 0; b < bodies; ++b) {
    std::copy(against_obstacles.begin(), against_obstacles.end(),
              mu_.begin() + static_cast<std::ptrdiff_t>(b * columns_ + bodies));
  }
  for (const PairFriction& pair : pairs) {
    const auto mu = static_cast<Real>(pair.friction);
    mu_[pair.body * columns_ + pair.other + (pair.against_body ? 0 : bodies)] = mu;
    if (pair.against_body) mu_[pair.other * columns_ + pair.body] = mu;
  }
}

}  // namespace stiction
