// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <btBulletCollisionCommon.h>

#include <memory>

#include "validation/engines/bullet/parameters.h"

namespace stiction::bullet {

inline btVector3 vector(const double v[3]) {
  return {static_cast<btScalar>(v[0]), static_cast<btScalar>(v[1]), static_cast<btScalar>(v[2])};
}

inline void copy(const btVector3& from, double to[3]) {
  for (int i = 0; i < 3; ++i) to[i] = static_cast<double>(from[i]);
}

/// A body's shape in the frame of its principal axes, as Bullet wants it.
struct BodyShape {
  std::unique_ptr<btCollisionShape> shape;
  btVector3 inertia;       ///< principal moments, kg m²
  btQuaternion principal;  ///< from the principal axes to the body's frame
};

BodyShape body_shape(const stiction_body& body, const Parameters& parameters);

/// A half-space: an infinite plane, or a big box whose upper face holds the given point.
struct ObstacleShape {
  std::unique_ptr<btCollisionShape> shape;
  btTransform pose;
};

ObstacleShape obstacle_shape(const stiction_obstacle& obstacle, const Parameters& parameters);

}  // namespace stiction::bullet
