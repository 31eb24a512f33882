// SPDX-License-Identifier: BSD-3-Clause
#include "solver/motion/loads.h"

#include <Eigen/Geometry>

#include "solver/observables.h"

namespace stiction {

namespace {

template <class Each>
void for_vertices(const Body& body, const Each& each) {
  for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v) {
    each(static_cast<std::size_t>(v));
  }
}

void add_force(const Scene& scene, const Body& body, const Vec3& load, std::vector<Force>& force) {
  for_vertices(body, [&](std::size_t v) { force[v].f += scene.mass[v] / body.mass * load; });
}

void add_couple(const Scene& scene, const State& state, const Body& body,
                const Eigen::Vector3d& couple, std::vector<Force>& force) {
  if (couple.isZero(0.0)) return;
  const Vec3 centre = centre_of_mass(scene, state, body).cast<Real>();
  const Vec3 turning = over_inertia(scene, state, body, couple).cast<Real>();
  for_vertices(body, [&](std::size_t v) {
    force[v].f += scene.mass[v] * turning.cross(state.position[v].x - centre);
  });
}

}  // namespace

void add_load_forces(const Scene& scene, double time, const State& state,
                     std::vector<Force>& force) {
  for (const Load& load : scene.loads) {
    const Body& body = scene.bodies[load.body];
    add_force(scene, body, load.force.at(time).cast<Real>(), force);
    add_couple(scene, state, body, load.couple.at(time), force);
  }
  for (const Spring& spring : scene.springs) {
    const Body& body = scene.bodies[spring.body];
    const Eigen::Vector3d stretch =
        spring.anchor + time * spring.anchor_velocity - centre_of_mass(scene, state, body);
    const Eigen::Vector3d pull = spring.stiffness * spring.axis.dot(stretch) * spring.axis;
    add_force(scene, body, pull.cast<Real>(), force);
  }
}

}  // namespace stiction
