// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/limit/limit_program.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace stiction::reference {

namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using Index = Eigen::Index;

/// A tangent along which friction is expected: down the load's slope, else away from the scene's
/// middle. An edge of the polygon there makes plane problems exact from the start.
Vector3d expected_slip(const LimitProblem& problem, const ContactPoint& contact,
                       const Vector3d& middle) {
  const Vector3d& n = contact.normal;
  const Vector3d outwards = contact.point - middle;
  for (const Vector3d& hint : {problem.live_gravity, problem.gravity, outwards}) {
    const Vector3d tangent = hint - hint.dot(n) * n;
    if (tangent.norm() > 1e-6 * hint.norm()) return tangent.normalized();
  }
  return n.unitOrthogonal();
}

}  // namespace

SlipDirections regular_polygons(const LimitProblem& problem, int facets, double start) {
  Vector3d middle = Vector3d::Zero();
  for (const ContactPoint& c : problem.contacts) middle += c.point;
  if (!problem.contacts.empty()) middle /= static_cast<double>(problem.contacts.size());
  SlipDirections directions;
  for (const ContactPoint& contact : problem.contacts) {
    const Vector3d t1 = expected_slip(problem, contact, middle);
    const Vector3d t2 = contact.normal.cross(t1);
    std::vector<Vector3d>& list = directions.emplace_back();
    for (int k = 0; k < facets; ++k) {
      const double angle = (k + start) * 2.0 * std::numbers::pi / facets;
      list.push_back(std::cos(angle) * t1 + std::sin(angle) * t2);
    }
  }
  return directions;
}

OutsidePolygons::OutsidePolygons(const LimitProblem& problem, int facets)
    : directions(regular_polygons(problem, facets, 0.5)),
      kappa((1.0 + 1e-12) / std::cos(std::numbers::pi / facets)) {}

LimitProgram build_program(const LimitProblem& problem, const SlipDirections& directions,
                           double friction, double load_factor, bool with_load, double kappa) {
  const LimitScale scale = scale_of(problem);
  LimitProgram program;
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const ContactPoint& contact = problem.contacts[c];
    const double radius = kappa * friction * contact.friction_scale;
    const std::size_t edges = radius > 0.0 ? directions[c].size() : 1;
    for (std::size_t k = 0; k < edges; ++k) {
      program.contact_of.push_back(static_cast<int>(c));
      program.tangent_of.push_back(radius > 0.0 ? Vector3d(radius * directions[c][k])
                                                : Vector3d(Vector3d::Zero()));
    }
  }
  const auto columns = static_cast<Index>(program.contact_of.size());
  program.a.setZero(row_count(problem), columns + (with_load ? 1 : 0));
  program.b.setZero(row_count(problem));
  for (Index column = 0; column < columns; ++column) {
    const auto k = static_cast<std::size_t>(column);
    const auto c = static_cast<std::size_t>(program.contact_of[k]);
    const Vector3d f = problem.contacts[c].normal + program.tangent_of[k];
    for_wrench<double>(problem, scale.length, problem.contacts[c], {f.x(), f.y(), f.z()},
                       [&](int row, double value) { program.a(row, column) += value; });
    for (std::size_t j = 0; j < problem.clamps.size(); ++j) {
      program.a(static_cast<Index>(6 * problem.bodies.size() + j), column) =
          membership(problem, j, c);
    }
  }
  const Vector3d gravity = problem.gravity + load_factor * problem.live_gravity;
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    const double share = problem.bodies[b].mass / scale.force;
    const auto row = static_cast<Index>(6 * b);
    program.b.segment<3>(row) = -share * gravity;
    if (with_load) program.a.block<3, 1>(row, columns) = share * problem.live_gravity;
  }
  for (std::size_t j = 0; j < problem.clamps.size(); ++j) {
    program.b[static_cast<Index>(6 * problem.bodies.size() + j)] =
        problem.clamps[j].total / scale.force;
  }
  return program;
}

ContactForces contact_forces(const LimitProblem& problem, const LimitProgram& program,
                             const VectorXd& x) {
  ContactForces forces = ContactForces::Zero(4, static_cast<Index>(problem.contacts.size()));
  for (std::size_t k = 0; k < program.contact_of.size(); ++k) {
    const double share = x[static_cast<Index>(k)];
    forces(0, program.contact_of[k]) += share;
    forces.col(program.contact_of[k]).tail<3>() += share * program.tangent_of[k];
  }
  return forces;
}

bool refine(const LimitProblem& problem, double friction, const VectorXd& y,
            SlipDirections& directions) {
  const double length = scale_of(problem).length;
  bool refined = false;
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const ContactPoint& contact = problem.contacts[c];
    const double radius = friction * contact.friction_scale;
    Vector3d velocity = Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      const Vector3d unit = Vector3d::Unit(k);
      for_wrench<double>(problem, length, contact, {unit.x(), unit.y(), unit.z()},
                         [&](int row, double value) { velocity[k] += value * y[row]; });
    }
    double work = velocity.dot(contact.normal);
    for (std::size_t j = 0; j < problem.clamps.size(); ++j) {
      work += membership(problem, j, c) * y[static_cast<Index>(6 * problem.bodies.size() + j)];
    }
    const Vector3d sliding = velocity - velocity.dot(contact.normal) * contact.normal;
    if (radius == 0.0 || work + radius * sliding.norm() < 1e-13) continue;
    const Vector3d direction = sliding.normalized();
    const auto known = [&](const Vector3d& d) { return (d - direction).norm() < 1e-9; };
    if (std::any_of(directions[c].begin(), directions[c].end(), known)) continue;
    directions[c].push_back(direction);
    refined = true;
  }
  return refined;
}

}  // namespace stiction::reference
