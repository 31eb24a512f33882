// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/detect.h"

#include "solver/lanes/packed_vec3.h"

namespace stiction {

void detect(const Scene& scene, double dt, const std::vector<Position>& position,
            const std::vector<Velocity>& predicted, OneSidedContacts& contacts, double time) {
  const auto h = static_cast<Real>(dt);
  contacts.clear();
  for (std::size_t o = 0; o < scene.half_spaces.size(); ++o) {
    const HalfSpace& obstacle = scene.half_spaces[o];
    const auto number = static_cast<std::int32_t>(o);
    const Vec3 velocity = obstacle.motion.mean_velocity(time, dt).cast<Real>();
    const Vec3 point = obstacle.point + obstacle.motion.at(time + dt).cast<Real>();
    in_registers(
        lane_width(), [&]() __attribute__((always_inline)) {
          const PackedVec3 normal(obstacle.normal), on(point);
          const Position* const at = position.data();
          const Velocity* const with = predicted.data();
          for (const int vertex : scene.surface_vertex) {
            const auto v = static_cast<std::size_t>(vertex);
            if (with[v].inverse_mass == 0.0) continue;
            const PackedVec3 x = PackedVec3::load(&at[v]) + h * PackedVec3::load(&with[v]);
            const Real depth = -normal.dot(x - on);
            if (depth > 0.0) {
              contacts.add(contact_key(number, vertex), vertex, number, depth, velocity);
            }
          }
        });
  }
}

}  // namespace stiction
