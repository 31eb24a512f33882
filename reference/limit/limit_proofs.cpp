// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/limit/limit_proofs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "reference/exact/fractions.h"

namespace stiction::reference {

namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using Index = Eigen::Index;

/// v − n (n · v)/(n · n): the normal is taken as it is, not as if its length were 1.
ExactVector tangential(const ExactVector& v, const ExactVector& n) {
  const Exact along = dot(v, n) / dot(n, n);
  return {v[0] - along * n[0], v[1] - along * n[1], v[2] - along * n[2]};
}

/// A double that is not below √q.
double root_from_above(const Exact& q) {
  double root = std::sqrt(CGAL::to_double(q)) * (1.0 + 1e-15);
  while (Exact(root) * Exact(root) < q) root = std::nextafter(root, kInfinity);
  return root;
}

/// The right side b − λ w, exactly, in scaled units; without the load's part if λ isn't wanted.
std::vector<Exact> exact_load(const LimitProblem& problem, const Vector3d& gravity, bool clamps) {
  const LimitScale scale = scale_of(problem);
  std::vector<Exact> load(static_cast<std::size_t>(row_count(problem)), Exact(0));
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    const Exact share = Exact(problem.bodies[b].mass) / Exact(scale.force);
    for (std::size_t k = 0; k < 3; ++k) {
      load[6 * b + k] = -share * Exact(gravity[static_cast<Index>(k)]);
    }
  }
  for (std::size_t j = 0; clamps && j < problem.clamps.size(); ++j) {
    load[6 * problem.bodies.size() + j] = Exact(problem.clamps[j].total) / Exact(scale.force);
  }
  return load;
}

/// What a mechanism y proves. For forces in the cones with Σ f_n ≤ force_max and a residual within
/// bounds,
///   yᵀb − λ yᵀw = yᵀA x + yᵀ(residual) ≤ force_max · max_c (v_n + μ s ‖v_t‖)₊ + residual ‖y‖∞,
/// v the virtual velocity at contact c (with a clamp's multiplier on its normal part), w the live
/// column. Returns  dead = yᵀb − (right side)  and  live = yᵀw:  an equilibrium needs
/// dead ≤ λ live.
struct Proof {
  Exact dead;
  Exact live;
};

Proof mechanism_proves(const LimitProblem& problem, double friction, const VectorXd& y,
                       const LimitOptions& options) {
  const double length = scale_of(problem).length;
  Exact worst(0);
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const ContactPoint& contact = problem.contacts[c];
    ExactVector velocity{Exact(0), Exact(0), Exact(0)};
    for (std::size_t k = 0; k < 3; ++k) {
      ExactVector unit{Exact(0), Exact(0), Exact(0)};
      unit[k] = Exact(1);
      for_wrench<Exact>(problem, length, contact, unit,
                        [&](int row, const Exact& value) { velocity[k] += value * Exact(y[row]); });
    }
    const ExactVector n = exact(contact.normal);
    const ExactVector sliding = tangential(velocity, n);
    Exact work = dot(velocity, n) + Exact(friction) * Exact(contact.friction_scale) *
                                        Exact(root_from_above(dot(sliding, sliding)));
    for (std::size_t j = 0; j < problem.clamps.size(); ++j) {
      const auto row = static_cast<Index>(6 * problem.bodies.size() + j);
      work += Exact(membership(problem, j, c)) * Exact(y[row]);
    }
    worst = std::max(worst, work);
  }
  const std::vector<Exact> dead = exact_load(problem, problem.gravity, true);
  const std::vector<Exact> live = exact_load(problem, problem.live_gravity, false);
  Proof proof{Exact(0), Exact(0)};
  for (std::size_t row = 0; row < dead.size(); ++row) {
    const Exact multiplier(y[static_cast<Index>(row)]);
    proof.dead += multiplier * dead[row];
    proof.live -= multiplier * live[row];
  }
  proof.dead -=
      Exact(options.force_max) * worst + Exact(options.residual) * Exact(y.cwiseAbs().maxCoeff());
  return proof;
}

}  // namespace

bool forces_prove(const LimitProblem& problem, double friction, double load_factor,
                  const ContactForces& forces, double residual) {
  const double length = scale_of(problem).length;
  std::vector<Exact> left = exact_load(problem, problem.gravity, true);
  const std::vector<Exact> live = exact_load(problem, problem.live_gravity, false);
  for (std::size_t row = 0; row < left.size(); ++row) left[row] += Exact(load_factor) * live[row];
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const ContactPoint& contact = problem.contacts[c];
    const auto column = static_cast<Index>(c);
    const ExactVector n = exact(contact.normal);
    const Exact normal_force(forces(0, column));
    ExactVector force = tangential(exact(forces.col(column).tail<3>()), n);
    const Exact bound = Exact(friction) * Exact(contact.friction_scale) * normal_force;
    if (normal_force < 0 || dot(force, force) > bound * bound) return false;
    for (std::size_t k = 0; k < 3; ++k) force[k] += normal_force * n[k];
    for_wrench<Exact>(problem, length, contact, force, [&](int row, const Exact& value) {
      left[static_cast<std::size_t>(row)] -= value;
    });
    for (std::size_t j = 0; j < problem.clamps.size(); ++j) {
      left[6 * problem.bodies.size() + j] -= Exact(membership(problem, j, c)) * normal_force;
    }
  }
  Exact sum(0);
  for (const Exact& row : left) sum += CGAL::abs(row);
  return sum <= Exact(residual);
}

bool mechanism_refutes(const LimitProblem& problem, double friction, double load_factor,
                       const VectorXd& y, const LimitOptions& options) {
  const Proof proof = mechanism_proves(problem, friction, y, options);
  return proof.dead > Exact(load_factor) * proof.live;
}

double load_bound(const LimitProblem& problem, double friction, const VectorXd& y,
                  const LimitOptions& options) {
  const Proof proof = mechanism_proves(problem, friction, y, options);
  if (proof.live < 0) {
    const double bound = std::nextafter(CGAL::to_double(proof.dead / proof.live), kInfinity);
    return bound < 0.0 ? -kInfinity : bound;
  }
  return proof.dead > Exact(options.load_max) * proof.live ? -kInfinity : kInfinity;
}

}  // namespace stiction::reference
