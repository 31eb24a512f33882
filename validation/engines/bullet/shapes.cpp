// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/bullet/shapes.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>

namespace stiction::bullet {

namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

btVector3 vector(const Vector3d& v) { return bullet::vector(v.data()); }

btQuaternion quaternion(const Eigen::Quaterniond& q) {
  return {static_cast<btScalar>(q.x()), static_cast<btScalar>(q.y()), static_cast<btScalar>(q.z()),
          static_cast<btScalar>(q.w())};
}

BodyShape hull(const stiction_body& body, const Parameters& parameters) {
  if (!body.convex) stiction_lacks("meshes that are not convex");
  const Matrix3d inertia = Eigen::Map<const Matrix3d>(&body.inertia[0][0]);  // symmetric
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(inertia);
  Matrix3d principal = axes.eigenvectors();
  if (principal.determinant() < 0.0) principal.col(0) *= -1.0;
  auto shape = std::make_unique<btConvexHullShape>();
  for (size_t k = 0; k < body.vertex_count; ++k) {
    const Vector3d vertex(body.vertices[k]);
    shape->addPoint(vector(Vector3d(principal.transpose() * vertex)), false);
  }
  shape->recalcLocalAabb();
  shape->optimizeConvexHull();
  shape->initializePolyhedralFeatures();  // so that faces touch in several points at once
  shape->setMargin(static_cast<btScalar>(parameters.hull_margin));
  return {std::move(shape), vector(axes.eigenvalues()), quaternion(Eigen::Quaterniond(principal))};
}

}  // namespace

BodyShape body_shape(const stiction_body& body, const Parameters& parameters) {
  const Vector3d moments(body.inertia[0][0], body.inertia[1][1], body.inertia[2][2]);
  const btQuaternion same = btQuaternion::getIdentity();
  switch (body.shape) {
    case STICTION_BOX:  // Bullet's box has its margin within
      return {std::make_unique<btBoxShape>(bullet::vector(body.size) / 2), vector(moments), same};
    case STICTION_BALL:
      return {std::make_unique<btSphereShape>(static_cast<btScalar>(body.radius)), vector(moments),
              same};
    case STICTION_MESH:
      return hull(body, parameters);
    case STICTION_POINT:
      break;
  }
  stiction_lacks("bodies without extension");
}

ObstacleShape obstacle_shape(const stiction_obstacle& obstacle, const Parameters& parameters) {
  const Vector3d normal(obstacle.normal), point(obstacle.point);
  btTransform pose = btTransform::getIdentity();
  if (!parameters.ground_is_box) {
    pose.setOrigin(vector(point));
    return {std::make_unique<btStaticPlaneShape>(vector(normal), btScalar(0)), pose};
  }
  const double half = 0.5 * parameters.ground_size;
  pose.setOrigin(vector(Vector3d(point - half * normal)));
  pose.setRotation(quaternion(Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), normal)));
  const auto edge = static_cast<btScalar>(half);
  return {std::make_unique<btBoxShape>(btVector3(edge, edge, edge)), pose};
}

}  // namespace stiction::bullet
