// SPDX-License-Identifier: BSD-3-Clause
#include "solver/observables.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/elasticity/rotation.h"

namespace stiction {

namespace {

// Mass-weighted mean of a vertex quantity over a body's vertices.
template <class Quantity>
Eigen::Vector3d mass_mean(const Scene& scene, const Body& body, const Quantity& quantity) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const auto first = static_cast<std::size_t>(body.first_vertex);
  for (std::size_t k = first; k < first + static_cast<std::size_t>(body.vertex_count); ++k) {
    sum += scene.mass[k] * quantity(k).template cast<double>();
  }
  return sum / body.mass;
}

}  // namespace

double kinetic_energy(const Scene& scene, const State& state) {
  double energy = 0.0;
  for (std::size_t k = 0; k < scene.mass.size(); ++k) {
    energy += 0.5 * scene.mass[k] * state.velocity[k].v.cast<double>().squaredNorm();
  }
  return energy;
}

double gravity_energy(const Scene& scene, const State& state, double time) {
  const Eigen::Vector3d g = scene.gravity.at(time);
  double energy = 0.0;
  for (std::size_t k = 0; k < scene.mass.size(); ++k) {
    energy -= scene.mass[k] * g.dot(state.position[k].x.cast<double>());
  }
  return energy;
}

Eigen::Vector3d linear_momentum(const Scene& scene, const State& state) {
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < scene.mass.size(); ++k) {
    momentum += scene.mass[k] * state.velocity[k].v.cast<double>();
  }
  return momentum;
}

Eigen::Vector3d angular_momentum(const Scene& scene, const State& state) {
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < scene.mass.size(); ++k) {
    momentum += scene.mass[k] *
                state.position[k].x.cast<double>().cross(state.velocity[k].v.cast<double>());
  }
  return momentum;
}

Eigen::Vector3d centre_of_mass(const Scene& scene, const State& state, const Body& body) {
  return mass_mean(scene, body, [&](std::size_t k) -> const Vec3& { return state.position[k].x; });
}

Eigen::Vector3d centre_velocity(const Scene& scene, const State& state, const Body& body) {
  return mass_mean(scene, body, [&](std::size_t k) -> const Vec3& { return state.velocity[k].v; });
}

Eigen::Matrix3d inertia(const Scene& scene, const State& state, const Body& body) {
  const Eigen::Vector3d c = centre_of_mass(scene, state, body);
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  const auto first = static_cast<std::size_t>(body.first_vertex);
  for (std::size_t k = first; k < first + static_cast<std::size_t>(body.vertex_count); ++k) {
    const Eigen::Vector3d r = state.position[k].x.cast<double>() - c;
    second += scene.mass[k] * r * r.transpose();
  }
  return second.trace() * Eigen::Matrix3d::Identity() - second;
}

Eigen::Vector3d over_inertia(const Scene& scene, const State& state, const Body& body,
                             const Eigen::Vector3d& moment) {
  // About an axis without inertia nothing turns.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(inertia(scene, state, body));
  const Eigen::Vector3d& about = axes.eigenvalues();
  const double nothing = 3 * std::numeric_limits<double>::epsilon() * about[2];
  const Eigen::Vector3d own = axes.eigenvectors().transpose() * moment;
  return axes.eigenvectors() *
         (about.array() > nothing).select(own.array() / about.array(), 0.0).matrix();
}

Eigen::Vector3d angular_velocity(const Scene& scene, const State& state, const Body& body) {
  const Eigen::Vector3d c = centre_of_mass(scene, state, body);
  const Eigen::Vector3d momentum =
      body.mass * mass_mean(scene, body, [&](std::size_t k) -> Eigen::Vector3d {
        return (state.position[k].x.cast<double>() - c).cross(state.velocity[k].v.cast<double>());
      });
  return over_inertia(scene, state, body, momentum);
}

Eigen::Matrix3d fitted_rotation(const Scene& scene, const State& state, const Body& body) {
  const Eigen::Vector3d c = centre_of_mass(scene, state, body);
  const Eigen::Vector3d c0 = mass_mean(scene, body, [&](std::size_t k) -> Vec3 {
    return scene.rest_position.col(static_cast<Eigen::Index>(k));
  });
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
  const auto first = static_cast<std::size_t>(body.first_vertex);
  for (std::size_t k = first; k < first + static_cast<std::size_t>(body.vertex_count); ++k) {
    moment +=
        scene.mass[k] * (state.position[k].x.cast<double>() - c) *
        (scene.rest_position.col(static_cast<Eigen::Index>(k)).cast<double>() - c0).transpose();
  }
  if (moment.norm() == 0.0) return Eigen::Matrix3d::Identity();
  return polar_rotation_by_svd(moment);
}

bool is_finite(const State& state) {
  const Real limit = std::ldexp(Real(1), std::numeric_limits<Real>::max_exponent / 5);
  const auto within = [&](const Vec3& one) { return (one.array().abs() < limit).all(); };
  return std::all_of(state.position.begin(), state.position.end(),
                     [&](const Position& p) { return within(p.x); }) &&
         std::all_of(state.velocity.begin(), state.velocity.end(),
                     [&](const Velocity& v) { return within(v.v); });
}

}  // namespace stiction
