// SPDX-License-Identifier: BSD-3-Clause
#include "solver/response/normal_force.h"

#include <algorithm>

namespace stiction {

void normal_forces(const Scene& scene, double dt, const State& state, Workspace& workspace) {
  const auto h = static_cast<Real>(dt);
  const double end_of_step = static_cast<double>(state.step) * dt + dt;
  OneSidedContacts& contacts = workspace.contacts;
  workspace.obstacle_order.make(contacts);
  workspace.obstacle_order.for_each_chunk(workspace.team, [&](std::size_t, const auto& chunk) {
    Vec3 point = Vec3::Zero();  // of the obstacle; contacts with one stand together
    for (std::size_t c = chunk.begin; c < chunk.end; ++c) {
      const auto i = static_cast<std::size_t>(contacts.vertex[c]);
      const HalfSpace& obstacle = scene.half_spaces[static_cast<std::size_t>(contacts.obstacle[c])];
      if (c == chunk.begin || contacts.obstacle[c] != contacts.obstacle[c - 1]) {
        point = obstacle.point + obstacle.motion.at(end_of_step).cast<Real>();
      }
      Velocity& vertex = workspace.velocity[i];
      const Vec3 x = state.position[i].x + h * vertex.v;
      const Real depth = std::max(Real(0), -obstacle.normal.dot(x - point));
      contacts.normal_force[c] = depth / (h * h * vertex.inverse_mass);
      vertex.v += depth / h * obstacle.normal;
    }
  });
}

}  // namespace stiction
