// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engine/protocol/rigid_body.h"

#include "reference/meshes/ball_mesh.h"
#include "reference/meshes/box_mesh.h"

namespace stiction {

namespace {

constexpr int kBallFrequency = 6;  // of the picture of a ball: 362 vertices

struct Outline {
  TetMesh operator()(const BoxShape& box) const {
    return reference::box_mesh(box.size, Eigen::Vector3i::Ones());
  }
  TetMesh operator()(const BallShape& ball) const {
    return reference::ball_mesh({.radius = ball.radius, .frequency = kBallFrequency});
  }
  TetMesh operator()(const MeshShape& shape) const { return shape.mesh; }
  TetMesh operator()(const PointShape&) const { return {}; }
};

// Σ over tetrahedra of ∫ x xᵀ dm: with corners a and mass m, m/20 (Σ a aᵀ + s sᵀ), s = Σ a.
Eigen::Matrix3d second_moment(const TetMesh& mesh, double mass) {
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
  double volume = 0.0;
  for (Eigen::Index e = 0; e < mesh.tetrahedra.cols(); ++e) {
    const double part = signed_volume(mesh, e);
    volume += part;
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < 4; ++k) {
      const Vec3 corner = mesh.vertices.col(mesh.tetrahedra(k, e));
      sum += corner;
      moment += part / 20.0 * corner * corner.transpose();
    }
    moment += part / 20.0 * sum * sum.transpose();
  }
  return volume > 0.0 ? Eigen::Matrix3d(mass / volume * moment) : moment;
}

struct SecondMoment {
  double mass;
  Eigen::Matrix3d operator()(const BoxShape& box) const {
    return (mass / 12.0 * box.size.cwiseAbs2()).asDiagonal();
  }
  Eigen::Matrix3d operator()(const BallShape& ball) const {
    return mass / 5.0 * ball.radius * ball.radius * Eigen::Matrix3d::Identity();
  }
  Eigen::Matrix3d operator()(const MeshShape& shape) const {
    return second_moment(shape.mesh, mass);
  }
  Eigen::Matrix3d operator()(const PointShape&) const { return Eigen::Matrix3d::Zero(); }
};

}  // namespace

RigidBody::RigidBody(const ProblemBody& body) : mass_(body.mass) {
  const Eigen::Matrix3d turn = body.rotation.toRotationMatrix();
  const Eigen::Matrix3d second = std::visit(SecondMoment{body.mass}, body.shape);
  const Eigen::Matrix3d about = second.trace() * Eigen::Matrix3d::Identity() - second;
  inertia_ = turn * about * turn.transpose();
  const TetMesh outline = std::visit(Outline{}, body.shape);
  vertices_ = turn * outline.vertices;
  surface_ = surface_triangles(outline.tetrahedra);
}

Eigen::Matrix3d RigidBody::inertia(const BodyMotion& motion) const {
  const Eigen::Matrix3d turn = motion.rotation.toRotationMatrix();
  return turn * inertia_ * turn.transpose();
}

double RigidBody::kinetic_energy(const BodyMotion& motion) const {
  return 0.5 * mass_ * motion.velocity.squaredNorm() +
         0.5 * motion.angular_velocity.dot(spin(motion));
}

Vec3 RigidBody::spin(const BodyMotion& motion) const {
  return inertia(motion) * motion.angular_velocity;
}

Eigen::Matrix3Xd RigidBody::vertices(const BodyMotion& motion) const {
  return (motion.rotation.toRotationMatrix() * vertices_).colwise() + motion.position;
}

}  // namespace stiction
