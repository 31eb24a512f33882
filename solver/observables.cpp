// SPDX-License-Identifier: BSD-3-Clause
#include "solver/observables.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>

#include "solver/elasticity/rotation.h"

namespace stiction {

namespace {

// Mass-weighted mean of a vertex quantity over a body's vertices.
template <class Quantity>
Vec3 mass_mean(const Scene& scene, const Body& body, const Quantity& quantity) {
  Vec3 sum = Vec3::Zero();
  const auto first = static_cast<std::size_t>(body.first_vertex);
  for (std::size_t k = first; k < first + static_cast<std::size_t>(body.vertex_count); ++k) {
    sum += scene.mass[k] * quantity(k);
  }
  return sum / body.mass;
}

}  // namespace

double kinetic_energy(const Scene& scene, const State& state) {
  double energy = 0.0;
  for (std::size_t k = 0; k < scene.mass.size(); ++k) {
    energy += 0.5 * scene.mass[k] * state.velocity[k].v.squaredNorm();
  }
  return energy;
}

double gravity_energy(const Scene& scene, const State& state, double time) {
  const Vec3 g = scene.gravity.at(time);
  double energy = 0.0;
  for (std::size_t k = 0; k < scene.mass.size(); ++k) {
    energy -= scene.mass[k] * g.dot(state.position[k].x);
  }
  return energy;
}

Vec3 linear_momentum(const Scene& scene, const State& state) {
  Vec3 momentum = Vec3::Zero();
  for (std::size_t k = 0; k < scene.mass.size(); ++k) {
    momentum += scene.mass[k] * state.velocity[k].v;
  }
  return momentum;
}

Vec3 angular_momentum(const Scene& scene, const State& state) {
  Vec3 momentum = Vec3::Zero();
  for (std::size_t k = 0; k < scene.mass.size(); ++k) {
    momentum += scene.mass[k] * state.position[k].x.cross(state.velocity[k].v);
  }
  return momentum;
}

Vec3 centre_of_mass(const Scene& scene, const State& state, const Body& body) {
  return mass_mean(scene, body, [&](std::size_t k) -> const Vec3& { return state.position[k].x; });
}

Vec3 centre_velocity(const Scene& scene, const State& state, const Body& body) {
  return mass_mean(scene, body, [&](std::size_t k) -> const Vec3& { return state.velocity[k].v; });
}

Mat3 inertia(const Scene& scene, const State& state, const Body& body) {
  const Vec3 c = centre_of_mass(scene, state, body);
  Mat3 second = Mat3::Zero();
  const auto first = static_cast<std::size_t>(body.first_vertex);
  for (std::size_t k = first; k < first + static_cast<std::size_t>(body.vertex_count); ++k) {
    const Vec3 r = state.position[k].x - c;
    second += scene.mass[k] * r * r.transpose();
  }
  return second.trace() * Mat3::Identity() - second;
}

Vec3 angular_velocity(const Scene& scene, const State& state, const Body& body) {
  const Vec3 c = centre_of_mass(scene, state, body);
  const Vec3 momentum = body.mass * mass_mean(scene, body, [&](std::size_t k) -> Vec3 {
                          return (state.position[k].x - c).cross(state.velocity[k].v);
                        });
  return inertia(scene, state, body).completeOrthogonalDecomposition().solve(momentum);
}

Mat3 fitted_rotation(const Scene& scene, const State& state, const Body& body) {
  const Vec3 c = centre_of_mass(scene, state, body);
  const Vec3 c0 = mass_mean(scene, body, [&](std::size_t k) -> Vec3 {
    return scene.rest_position.col(static_cast<Eigen::Index>(k));
  });
  Mat3 moment = Mat3::Zero();
  const auto first = static_cast<std::size_t>(body.first_vertex);
  for (std::size_t k = first; k < first + static_cast<std::size_t>(body.vertex_count); ++k) {
    moment += scene.mass[k] * (state.position[k].x - c) *
              (scene.rest_position.col(static_cast<Eigen::Index>(k)) - c0).transpose();
  }
  if (moment.norm() == 0.0) return Mat3::Identity();
  return polar_rotation_by_svd(moment);
}

bool is_finite(const State& state) {
  return std::all_of(state.position.begin(), state.position.end(),
                     [](const Position& p) { return p.x.allFinite(); }) &&
         std::all_of(state.velocity.begin(), state.velocity.end(),
                     [](const Velocity& v) { return v.v.allFinite(); });
}

}  // namespace stiction
