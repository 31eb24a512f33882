// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/limit/limit_equations.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace stiction::reference {

namespace {

using Eigen::Vector3d;

void demand(bool holds, const std::string& what) {
  if (!holds) throw std::invalid_argument("limit analysis: " + what);
}

double power_of_two_near(double value) {
  int exponent = 0;
  std::frexp(value, &exponent);
  return std::ldexp(1.0, exponent);
}

}  // namespace

void check(const LimitProblem& problem, double friction, double load, const LimitOptions& options) {
  if (const std::string wrong = options.check(); !wrong.empty()) demand(false, wrong);
  demand(friction >= 0.0 && std::isfinite(friction), "μ is negative or not finite");
  demand(std::isfinite(load), "the load factor is not finite");
  const auto bodies = static_cast<int>(problem.bodies.size());
  const auto contacts = static_cast<int>(problem.contacts.size());
  demand(bodies > 0, "no bodies");
  double mass = 0.0;
  for (const RigidBody& body : problem.bodies) {
    demand(body.mass >= 0.0 && std::isfinite(body.mass), "a mass is negative or not finite");
    demand(body.center_of_mass.allFinite(), "a centre of mass is not finite");
    mass += body.mass;
  }
  for (int c = 0; c < contacts; ++c) {
    const ContactPoint& contact = problem.contacts[static_cast<std::size_t>(c)];
    const std::string name = "contact " + std::to_string(c);
    demand(contact.body_a >= 0 && contact.body_a < bodies, name + ": body_a doesn't exist");
    demand(contact.body_b >= kFixed && contact.body_b < bodies, name + ": body_b doesn't exist");
    demand(contact.body_a != contact.body_b, name + ": a body touches itself");
    demand(contact.point.allFinite(), name + ": the point is not finite");
    demand(std::abs(contact.normal.norm() - 1.0) < 1e-9, name + ": the normal is not of length 1");
    demand(contact.friction_scale >= 0.0 && std::isfinite(contact.friction_scale),
           name + ": the friction scale is negative or not finite");
  }
  for (const PrescribedNormalForce& clamp : problem.clamps) {
    demand(clamp.total >= 0.0 && std::isfinite(clamp.total), "a clamp pulls, or is not finite");
    for (const int c : clamp.contacts)
      demand(c >= 0 && c < contacts, "a clamp has no such contact");
  }
  demand(problem.gravity.allFinite() && problem.live_gravity.allFinite(), "gravity is not finite");
  demand(mass * (problem.gravity.norm() + problem.live_gravity.norm()) > 0.0, "there is no load");
}

LimitScale scale_of(const LimitProblem& problem) {
  double mass = 0.0;
  Vector3d low = problem.bodies.front().center_of_mass;
  Vector3d high = low;
  const auto include = [&](const Vector3d& x) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  };
  for (const RigidBody& body : problem.bodies) {
    mass += body.mass;
    include(body.center_of_mass);
  }
  for (const ContactPoint& contact : problem.contacts) include(contact.point);
  const double extent = (high - low).norm();
  const double gravity = std::max(problem.gravity.norm(), problem.live_gravity.norm());
  return {power_of_two_near(mass * gravity), power_of_two_near(extent > 0.0 ? extent : 1.0)};
}

int row_count(const LimitProblem& problem) {
  return static_cast<int>(6 * problem.bodies.size() + problem.clamps.size());
}

int membership(const LimitProblem& problem, std::size_t j, std::size_t c) {
  const std::vector<int>& members = problem.clamps[j].contacts;
  return static_cast<int>(std::count(members.begin(), members.end(), static_cast<int>(c)));
}

}  // namespace stiction::reference
