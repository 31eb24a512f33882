// SPDX-License-Identifier: BSD-3-Clause
#include "solver/scene/time_step_limit.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "solver/scene/body_at_rest.h"

namespace stiction {

namespace {

// √(β² + 4/ω²) − β, without the difference, which is 0 for β ω ≫ 1e8.
double time_step_limit(double omega2, const Material& material) {
  const double beta = material.damping_time;
  return 4.0 / omega2 / (std::sqrt(beta * beta + 4.0 / omega2) + beta);
}

// Columns ∇N₀ … ∇N₃, 1/m.
Eigen::Matrix<double, 3, 4> shape_gradients(const TetMesh& mesh, Eigen::Index tetrahedron) {
  Eigen::Matrix<double, 3, 4> gradients;
  gradients.rightCols<3>() = rest_edges(mesh, tetrahedron).inverse().transpose();
  gradients.col(0) = -gradients.rightCols<3>().rowwise().sum();
  return gradients;
}

// A tetrahedron at rest, of linear elasticity.
struct LinearElement {
  Eigen::Vector4i vertex;
  Eigen::Matrix<double, 3, 4> gradients;  // 1/m
  double volume;                          // m³

  // Adds what displacements u, m, give as forces, N, but for the sign.
  void add_forces(const Lame& lame, const Eigen::Matrix3Xd& u, Eigen::Matrix3Xd& forces) const {
    Eigen::Matrix<double, 3, 4> own;
    for (int k = 0; k < 4; ++k) own.col(k) = u.col(vertex[k]);
    const Eigen::Matrix3d gradient = own * gradients.transpose();
    Eigen::Matrix3d stress = lame.mu * (gradient + gradient.transpose());
    stress.diagonal().array() += lame.lambda * gradient.trace();
    own = volume * stress * gradients;
    for (int k = 0; k < 4; ++k) forces.col(vertex[k]) += own.col(k);
  }
};

std::vector<LinearElement> linear_elements(const TetMesh& mesh) {
  std::vector<LinearElement> elements;
  for (Eigen::Index e = 0; e < mesh.tetrahedra.cols(); ++e) {
    elements.push_back({mesh.tetrahedra.col(e), shape_gradients(mesh, e), signed_volume(mesh, e)});
  }
  return elements;
}

// 1/√m of each vertex, 0 where it is pinned.
Eigen::RowVectorXd inverse_roots(const BodyDescription& body) {
  const std::vector<double> mass = lumped_masses(body);
  Eigen::RowVectorXd roots(body.mesh.vertices.cols());
  for (Eigen::Index k = 0; k < roots.size(); ++k) {
    roots[k] = 1.0 / std::sqrt(mass[static_cast<std::size_t>(k)]);
  }
  for (const int k : body.pinned) roots[k] = 0.0;
  return roots;
}

// Numbers that have no pattern, the same on each machine.
Eigen::Matrix3Xd scattered(Eigen::Index count) {
  std::mt19937 generator;
  Eigen::Matrix3Xd numbers(3, count);
  for (double& number : numbers.reshaped()) {
    number = static_cast<double>(generator()) / 0x1p31 - 1.0;
  }
  return numbers;
}

}  // namespace

double element_time_step_limit(const TetMesh& mesh, Eigen::Index tetrahedron,
                               const Material& material) {
  // ω² of the lumped element: eigenvalues of (4/ρ) Lᵀ B Bᵀ L with D = L Lᵀ the elasticity matrix
  // (Voigt) and B the 6 × 12 strain matrix; the six zero modes drop out by working in strain space.
  const Eigen::Matrix<double, 3, 4> gradients = shape_gradients(mesh, tetrahedron);
  Eigen::Matrix<double, 6, 12> b = Eigen::Matrix<double, 6, 12>::Zero();
  for (int k = 0; k < 4; ++k) {
    const Eigen::Vector3d g = gradients.col(k);
    auto columns = b.middleCols<3>(3 * k);
    columns.diagonal() = g;
    columns(3, 0) = g.y();
    columns(3, 1) = g.x();
    columns(4, 1) = g.z();
    columns(4, 2) = g.y();
    columns(5, 0) = g.z();
    columns(5, 2) = g.x();
  }
  const Lame parameters = lame(material);
  Eigen::Matrix<double, 6, 6> d = Eigen::Matrix<double, 6, 6>::Zero();
  d.topLeftCorner<3, 3>().setConstant(parameters.lambda);
  d.topLeftCorner<3, 3>().diagonal().array() += 2.0 * parameters.mu;
  d.bottomRightCorner<3, 3>().diagonal().setConstant(parameters.mu);
  const Eigen::Matrix<double, 6, 6> l = d.llt().matrixL();
  const Eigen::Matrix<double, 6, 6> operator_ = l.transpose() * (b * b.transpose()) * l;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(operator_,
                                                                         Eigen::EigenvaluesOnly);
  const double omega2 = 4.0 / material.density * eigen.eigenvalues().maxCoeff();
  return time_step_limit(omega2, material);
}

double body_time_step_limit(const BodyDescription& body) {
  constexpr int kPowers = 100;
  const Lame parameters = lame(body.material);
  const std::vector<LinearElement> elements = linear_elements(body.mesh);
  const Eigen::RowVectorXd roots = inverse_roots(body);
  Eigen::Matrix3Xd y = scattered(roots.size()), forces(3, roots.size());
  double omega2 = 0.0;
  for (int k = 0; k < kPowers; ++k) {
    y.array().rowwise() *= roots.array() / y.norm();
    forces.setZero();
    for (const LinearElement& element : elements) element.add_forces(parameters, y, forces);
    y = forces.array().rowwise() * roots.array();
    omega2 = y.norm();
    if (omega2 == 0.0) return std::numeric_limits<double>::infinity();
  }
  return time_step_limit(omega2, body.material);
}

}  // namespace stiction
