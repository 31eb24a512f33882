// SPDX-License-Identifier: BSD-3-Clause
#include "solver/response/normal_force.h"

#include <algorithm>

namespace stiction {

void normal_forces(const Scene& scene, double dt, const std::vector<Position>& position,
                   std::vector<Velocity>& velocity, OneSidedContacts& contacts, double time) {
  const auto h = static_cast<Real>(dt);
  Vec3 point = Vec3::Zero();  // of the obstacle; contacts with one stand together
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const auto i = static_cast<std::size_t>(contacts.vertex[c]);
    const HalfSpace& obstacle = scene.half_spaces[static_cast<std::size_t>(contacts.obstacle[c])];
    if (c == 0 || contacts.obstacle[c] != contacts.obstacle[c - 1]) {
      point = obstacle.point + obstacle.motion.at(time + dt).cast<Real>();
    }
    const Vec3 x = position[i].x + h * velocity[i].v;
    const Real depth = std::max(Real(0), -obstacle.normal.dot(x - point));
    contacts.normal_force[c] = depth / (h * h * velocity[i].inverse_mass);
    velocity[i].v += depth / h * obstacle.normal;
  }
}

}  // namespace stiction
