// SPDX-License-Identifier: BSD-3-Clause
#include "solver/motion/predict.h"

#include "solver/lanes/packed_vec3.h"

namespace stiction {

void gravity_forces(const Scene& scene, double time, std::vector<Force>& force, const Team* team) {
  const Vec3 g = scene.gravity.at(time).cast<Real>();
  force.resize(scene.mass.size());
  for_ranges(team, force.size(), kVerticesToShare, [&](std::size_t begin, std::size_t end) {
    in_registers(
        lane_width(), [&]() __attribute__((always_inline)) {
          const PackedVec3 gravity(g);
          const Real* const mass = scene.mass.data();
          Force* const to = force.data();
          for (std::size_t k = begin; k < end; ++k) (mass[k] * gravity).store(&to[k]);
        });
  });
}

void add_drag_forces(const Scene& scene, double time, const std::vector<Velocity>& velocity,
                     std::vector<Force>& force) {
  const auto rate = static_cast<Real>(scene.drag.at(time));
  if (rate == 0.0) return;
  for (std::size_t k = 0; k < force.size(); ++k) force[k].f -= rate * scene.mass[k] * velocity[k].v;
}

void predict(Real dt, const std::vector<Force>& force, const std::vector<Velocity>& velocity_t0,
             std::vector<Velocity>& predicted, const Team* team) {
  predicted.resize(velocity_t0.size());
  for_ranges(team, predicted.size(), kVerticesToShare, [&](std::size_t begin, std::size_t end) {
    in_registers(
        lane_width(), [&]() __attribute__((always_inline)) {
          const Velocity* const from = velocity_t0.data();
          const Force* const forces = force.data();
          Velocity* const to = predicted.data();
          const Real h = dt;
          for (std::size_t k = begin; k < end; ++k) {
            const PackedVec3 old = PackedVec3::load(&from[k]);
            const PackedVec3 gain = h * old.fourths() * PackedVec3::load(&forces[k]);
            (old + gain).with_fourth(old).store(&to[k]);
          }
        });
  });
}

void follow_motions(const Scene& scene, double time, double dt, std::vector<Velocity>& predicted) {
  for (const Body& body : scene.bodies) {
    if (!body.motion.moves()) continue;
    const Vec3 velocity = body.motion.mean_velocity(time, dt).cast<Real>();
    for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v) {
      Velocity& vertex = predicted[static_cast<std::size_t>(v)];
      if (vertex.inverse_mass == 0.0) vertex.v = velocity;
    }
  }
}

}  // namespace stiction
