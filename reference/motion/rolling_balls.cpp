// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/motion/rolling_balls.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <cmath>
#include <stdexcept>

namespace stiction::reference {

namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

Matrix3d skew(const Vector3d& v) {
  Matrix3d s;
  s << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return s;
}

Vector3d normal_of(const std::vector<RigidBall>& balls, const BallContact& contact) {
  if (contact.a < 0) return Vector3d::UnitZ();
  return (balls[static_cast<std::size_t>(contact.b)].centre -
          balls[static_cast<std::size_t>(contact.a)].centre)
      .normalized();
}

// Velocity of b's material point over a's, per contact, from (v, ω) of each ball.
MatrixXd slip_matrix(const std::vector<RigidBall>& balls,
                     const std::vector<BallContact>& contacts) {
  MatrixXd jacobian = MatrixXd::Zero(3 * static_cast<Eigen::Index>(contacts.size()),
                                     6 * static_cast<Eigen::Index>(balls.size()));
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Vector3d n = normal_of(balls, contacts[k]);
    const auto row = 3 * static_cast<Eigen::Index>(k);
    const auto add = [&](int ball, double sign) {
      jacobian.block<3, 3>(row, 6 * ball) = sign * Matrix3d::Identity();
      jacobian.block<3, 3>(row, 6 * ball + 3) =
          balls[static_cast<std::size_t>(ball)].radius * skew(n);
    };
    add(contacts[k].b, 1.0);
    if (contacts[k].a >= 0) add(contacts[k].a, -1.0);
  }
  return jacobian;
}

void demand_touching(const std::vector<RigidBall>& balls,
                     const std::vector<BallContact>& contacts) {
  for (const BallContact& contact : contacts) {
    const RigidBall& b = balls.at(static_cast<std::size_t>(contact.b));
    double gap = b.centre.z() - b.radius;
    if (contact.a >= 0) {
      const RigidBall& a = balls.at(static_cast<std::size_t>(contact.a));
      gap = (b.centre - a.centre).norm() - a.radius - b.radius;
    }
    if (!(std::abs(gap) <= 1e-9 * b.radius)) {
      throw std::invalid_argument("balls in contact must touch");
    }
  }
}

}  // namespace

RollingMotions rolling_motions(const std::vector<RigidBall>& balls,
                               const std::vector<BallContact>& contacts, double gravity) {
  demand_touching(balls, contacts);
  const MatrixXd jacobian = slip_matrix(balls, contacts);
  const Eigen::Index size = jacobian.cols();
  VectorXd mass(size), weight = VectorXd::Zero(size);
  for (std::size_t b = 0; b < balls.size(); ++b) {
    const auto at = 6 * static_cast<Eigen::Index>(b);
    mass.segment<3>(at).setConstant(balls[b].mass);
    mass.segment<3>(at + 3).setConstant(0.4 * balls[b].mass * balls[b].radius * balls[b].radius);
    weight[at + 2] = -gravity * balls[b].mass;
  }
  RollingMotions motions;
  const MatrixXd transposed = jacobian.transpose();
  const VectorXd force = transposed.colPivHouseholderQr().solve(-weight);
  motions.residual = (transposed * force + weight).norm();
  motions.friction.resize(static_cast<Eigen::Index>(contacts.size()));
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    const Vector3d f = force.segment<3>(3 * at), n = normal_of(balls, contacts[k]);
    motions.friction[at] = (f - f.dot(n) * n).norm() / f.dot(n);
  }
  Eigen::FullPivLU<MatrixXd> decomposition(jacobian);
  decomposition.setThreshold(1e-10);
  const MatrixXd kernel = decomposition.kernel();
  MatrixXd stiffness(kernel.cols(), kernel.cols());
  const double step = 1e-6;  // m: of central differences
  for (Eigen::Index q = 0; q < kernel.cols(); ++q) {
    const auto moved = [&](double by) {
      std::vector<RigidBall> there = balls;
      for (std::size_t b = 0; b < balls.size(); ++b) {
        there[b].centre += by * kernel.col(q).segment<3>(6 * static_cast<Eigen::Index>(b));
      }
      return slip_matrix(there, contacts);
    };
    const MatrixXd change = (moved(step) - moved(-step)) / (2.0 * step);
    stiffness.col(q) = kernel.transpose() * (change.transpose() * force);
  }
  const MatrixXd inertia = kernel.transpose() * mass.asDiagonal() * kernel;
  const MatrixXd operation = inertia.colPivHouseholderQr().solve(stiffness);
  const Eigen::EigenSolver<MatrixXd> solver(operation, false);
  motions.rates2 = solver.eigenvalues().real();
  motions.basis = kernel;
  return motions;
}

}  // namespace stiction::reference
