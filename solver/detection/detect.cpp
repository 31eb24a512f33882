// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/detect.h"

#include "solver/detection/boxes.h"
#include "solver/lanes/packed_vec3.h"

namespace stiction {

void detect(const Scene& scene, double dt, const std::vector<Position>& position,
            const std::vector<Velocity>& predicted, OneSidedContacts& contacts, double time,
            const PairSearch* bounds) {
  const auto h = static_cast<Real>(dt);
  contacts.clear();
  for (std::size_t o = 0; o < scene.half_spaces.size(); ++o) {
    const HalfSpace& obstacle = scene.half_spaces[o];
    const auto number = static_cast<std::int32_t>(o);
    const Vec3 velocity = obstacle.motion.mean_velocity(time, dt).cast<Real>();
    const Vec3 point = obstacle.point + obstacle.motion.at(time + dt).cast<Real>();
    const auto test = [&](std::size_t begin, std::size_t end) {
      in_registers(
          lane_width(), [&]() __attribute__((always_inline)) {
            const PackedVec3 normal(obstacle.normal), on(point);
            const Position* const at = position.data();
            const Velocity* const with = predicted.data();
            for (std::size_t k = begin; k < end; ++k) {
              const int vertex = scene.surface_vertex[k];
              const auto v = static_cast<std::size_t>(vertex);
              if (with[v].inverse_mass == 0.0) continue;
              const PackedVec3 x = PackedVec3::load(&at[v]) + h * PackedVec3::load(&with[v]);
              const Real depth = -normal.dot(x - on);
              if (depth > 0.0) {
                contacts.add(contact_key(number, vertex), vertex, number, depth, velocity);
              }
            }
          });
    };
    if (bounds == nullptr) {
      test(0, scene.surface_vertex.size());
      continue;
    }
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      // The box is a skin wider than where the body's vertices may be, which is far above round-off.
      if (clear_of(bounds->box[b], obstacle.normal, point)) continue;
      test(scene.bodies[b].surface_begin, scene.bodies[b].surface_end);
    }
  }
}

}  // namespace stiction
