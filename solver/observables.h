// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/scene/scene.h"
#include "solver/state.h"

namespace stiction {

// Pure functions of scene and state. SI units. In double, whatever Real is, so that what is told of a
// state does not add to its errors.

/// ½ Σ m v², J; pinned vertices do not move and count nothing.
double kinetic_energy(const Scene& scene, const State& state);

/// −Σ m g·x, J, with gravity at the state's time.
double gravity_energy(const Scene& scene, const State& state, double time);

/// Σ m v, kg m/s.
Eigen::Vector3d linear_momentum(const Scene& scene, const State& state);

/// Σ x × m v about the origin, kg m²/s.
Eigen::Vector3d angular_momentum(const Scene& scene, const State& state);

/// Centre of mass, m, and its velocity, m/s, of one body.
Eigen::Vector3d centre_of_mass(const Scene& scene, const State& state, const Body& body);
Eigen::Vector3d centre_velocity(const Scene& scene, const State& state, const Body& body);

/// Σ m (|r|² 1 − r rᵀ) of one body's vertices about its centre of mass, kg m².
Eigen::Matrix3d inertia(const Scene& scene, const State& state, const Body& body);

/// J⁻¹ m of an angular momentum (its angular velocity, rad/s) or a couple (its angular
/// acceleration, rad/s²); of a body that can't resist it, a point or a rod, the shortest.
Eigen::Vector3d over_inertia(const Scene& scene, const State& state, const Body& body,
                             const Eigen::Vector3d& moment);

/// Of the rigid motion with the body's angular momentum about its centre, rad/s; zero for a point.
Eigen::Vector3d angular_velocity(const Scene& scene, const State& state, const Body& body);

/// Rotation from the initial positions that fits a body's present ones best, mass-weighted: the
/// polar rotation of Σ m (x − c)(X − C)ᵀ. The identity for a point.
Eigen::Matrix3d fitted_rotation(const Scene& scene, const State& state, const Body& body);

/// True when all positions and velocities are numbers, and so small (2.6e61 m, m/s; 3.4e7 in single
/// precision) that energies, which are of their fourth power at most, are numbers too.
bool is_finite(const State& state);

}  // namespace stiction
