// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/user/start_overlap.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "reference/exact/shared_space.h"
#include "reference/meshes/box_mesh.h"

namespace stiction {

namespace {

using Eigen::Vector3d;

struct Placed {
  const ProblemBody& body;

  reference::Solid operator()(const BoxShape& box) const {
    return meshed(reference::box_mesh(box.size, Eigen::Vector3i::Ones()));
  }
  reference::Solid operator()(const MeshShape& shape) const { return meshed(shape.mesh); }
  reference::Solid operator()(const BallShape& ball) const {
    return reference::SolidBall{body.position, ball.radius};
  }
  reference::Solid operator()(const PointShape&) const {
    return reference::SolidPoint{body.position};
  }

 private:
  reference::Solid meshed(TetMesh mesh) const {
    std::vector<bool> held;
    for (Eigen::Index v = 0; body.held && v < mesh.vertices.cols(); ++v) {
      const Vector3d x = mesh.vertices.col(v);
      held.push_back((x - body.held->point).dot(body.held->normal) <= 0.0);
    }
    mesh.vertices = (body.rotation.toRotationMatrix() * mesh.vertices).colwise() + body.position;
    return reference::SolidMesh{std::move(mesh), std::move(held)};
  }
};

// How far a solid reaches below a half-space's surface, m.
struct DepthIn {
  const Obstacle& obstacle;

  double operator()(const reference::SolidMesh& solid) const {
    double deepest = 0.0;
    for (Eigen::Index v = 0; v < solid.mesh.vertices.cols(); ++v) {
      if (!solid.held.empty() && solid.held[static_cast<std::size_t>(v)]) continue;
      deepest = std::max(deepest, below(solid.mesh.vertices.col(v)));
    }
    return deepest;
  }
  double operator()(const reference::SolidBall& ball) const {
    return below(ball.centre) + ball.radius;
  }
  double operator()(const reference::SolidPoint& point) const { return below(point.position); }

 private:
  double below(const Vector3d& x) const { return obstacle.normal.dot(obstacle.point - x); }
};

constexpr double kFarthest = 1e30;  // m: beyond, exact predicates run out of exponents

}  // namespace

std::string overlap_at_start(const Problem& problem) {
  std::vector<reference::Solid> solids;
  double size = 0.0;
  for (const ProblemBody& body : problem.bodies) {
    const double reach = longest_edge(body.shape) + body.position.cwiseAbs().maxCoeff();
    if (!(reach < kFarthest)) return fmt::format("'{}' begins too far away", body.name);
    size = std::max(size, reach);
    solids.push_back(std::visit(Placed{body}, body.shape));
  }
  for (const Obstacle& obstacle : problem.obstacles) {
    size = std::max(size, obstacle.point.cwiseAbs().maxCoeff());
  }
  // A vertex is put down by some ten operations, each rounded by an ulp of the largest coordinate.
  const double allowed = 32.0 * std::numeric_limits<double>::epsilon() * size;
  for (std::size_t b = 0; b < solids.size(); ++b) {
    for (const Obstacle& obstacle : problem.obstacles) {
      const double depth = std::visit(DepthIn{obstacle}, solids[b]);
      if (!(depth > allowed)) continue;
      return fmt::format("'{}' begins {:.3g} m inside obstacle '{}'", problem.bodies[b].name, depth,
                         obstacle.name);
    }
  }
  if (!(allowed > 0.0)) return {};
  const auto found = reference::shared_space(solids, allowed);
  if (!found) return {};
  return fmt::format("'{}' and '{}' begin inside each other, by at least {:.2g} m",
                     problem.bodies[found->first].name, problem.bodies[found->second].name,
                     2.0 * found->depth);
}

}  // namespace stiction
