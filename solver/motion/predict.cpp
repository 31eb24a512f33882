// SPDX-License-Identifier: BSD-3-Clause
#include "solver/motion/predict.h"

namespace stiction {

void gravity_forces(const Scene& scene, double time, std::vector<Force>& force, const Team* team) {
  const Vec3 g = scene.gravity.at(time).cast<Real>();
  force.resize(scene.mass.size());
  for_ranges(team, force.size(), kVerticesToShare, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) force[k] = {scene.mass[k] * g, 0};
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
    for (std::size_t k = begin; k < end; ++k) {
      const Velocity& old = velocity_t0[k];
      predicted[k] = {old.v + dt * old.inverse_mass * force[k].f, old.inverse_mass};
    }
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
