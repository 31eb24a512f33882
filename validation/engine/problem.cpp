// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engine/problem.h"

namespace stiction {

double longest_edge(const Shape& shape) {
  if (const auto* const box = std::get_if<BoxShape>(&shape)) return box->size.maxCoeff();
  if (const auto* const ball = std::get_if<BallShape>(&shape)) return 2.0 * ball->radius;
  if (const auto* const mesh = std::get_if<MeshShape>(&shape)) {
    const Eigen::Matrix3Xd& x = mesh->mesh.vertices;
    if (x.cols() > 0) return (x.rowwise().maxCoeff() - x.rowwise().minCoeff()).maxCoeff();
  }
  return 0.0;
}

Eigen::AlignedBox3d bounds_of(const Problem& problem) {
  Eigen::AlignedBox3d bounds;
  for (const ProblemBody& body : problem.bodies) {
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(0.5 * longest_edge(body.shape));
    bounds.extend(body.position - reach);
    bounds.extend(body.position + reach);
  }
  return bounds;
}

}  // namespace stiction
