// SPDX-License-Identifier: GPL-3.0-or-later
// What a rigid body would be called that moves as a deformable one does on the whole.
#include <Eigen/Dense>
#include <Eigen/Geometry>

#include "validation/engines/bullet_deformable/world.h"

namespace stiction::bullet_deformable {

namespace {

using Eigen::Matrix3d;

Vector3d vector(const btVector3& v) {
  return {static_cast<double>(v.x()), static_cast<double>(v.y()), static_cast<double>(v.z())};
}

}  // namespace

Vector3d World::node(size_t body, size_t index) const {
  return vector(bodies_[body]->m_nodes[static_cast<int>(index)].m_x);
}

Vector3d World::velocity(size_t body, size_t index) const {
  return vector(bodies_[body]->m_nodes[static_cast<int>(index)].m_v);
}

// x̄ = Σ m x / M, v̄ likewise; ω = I⁻¹ Σ m (x − x̄) × v; the rotation is that nearest to
// Σ m (x − x̄) Xᵀ, X at rest.
void World::body(size_t index, stiction_body_state& state) const {
  const SoftMesh& mesh = meshes_[index];
  const double mass = problem_.bodies[index].mass;
  Vector3d centre = Vector3d::Zero(), mean = Vector3d::Zero(), spin = Vector3d::Zero();
  for (size_t k = 0; k < mesh.nodes.size(); ++k) {
    centre += mesh.masses[k] / mass * node(index, k);
    mean += mesh.masses[k] / mass * velocity(index, k);
  }
  Matrix3d turned = Matrix3d::Zero(), inertia = Matrix3d::Zero();
  for (size_t k = 0; k < mesh.nodes.size(); ++k) {
    const double m = mesh.masses[k];
    const Vector3d arm = node(index, k) - centre;
    turned += m * arm * mesh.nodes[k].transpose();
    inertia += m * (arm.squaredNorm() * Matrix3d::Identity() - arm * arm.transpose());
    spin += m * arm.cross(velocity(index, k));
  }
  const Eigen::JacobiSVD<Matrix3d> parts(turned, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Matrix3d u = parts.matrixU();
  if ((u * parts.matrixV().transpose()).determinant() < 0.0) u.col(2) *= -1.0;
  const Eigen::Quaterniond rotation(Matrix3d(u * parts.matrixV().transpose()));
  Eigen::Map<Vector3d>(state.position) = centre;
  Eigen::Map<Vector3d>(state.velocity) = mean;
  Eigen::Map<Vector3d>(state.angular_velocity) = inertia.inverse() * spin;
  const double wxyz[] = {rotation.w(), rotation.x(), rotation.y(), rotation.z()};
  std::copy_n(wxyz, 4, state.rotation);
}

void World::momenta(Vector3d& linear, Vector3d& angular) const {
  linear = angular = Vector3d::Zero();
  for (size_t b = 0; b < meshes_.size(); ++b) {
    for (size_t k = 0; k < meshes_[b].nodes.size(); ++k) {
      const Vector3d p = meshes_[b].masses[k] * velocity(b, k);
      linear += p;
      angular += node(b, k).cross(p);
    }
  }
}

}  // namespace stiction::bullet_deformable
