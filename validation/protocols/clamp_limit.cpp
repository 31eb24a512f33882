// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/protocols/clamp_limit.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace stiction {

namespace {

// The rectangle in which a face across x lies: its x and the corners in y and z.
struct Face {
  double x = 0.0;
  Vec3 low, high;
};

const Eigen::Matrix3Xd& vertices_of(const ProblemBody& body) {
  return std::get<MeshShape>(body.shape).mesh.vertices;
}

// `side` −1: the left face.
Face face_of(const ProblemBody& body, double side) {
  const Eigen::Matrix3Xd& vertices = vertices_of(body);
  const Vec3 low = body.position + vertices.rowwise().minCoeff();
  const Vec3 high = body.position + vertices.rowwise().maxCoeff();
  return {side < 0.0 ? low.x() : high.x(), low, high};
}

// Vertices of `body` in its own face that lie on the other one too.
std::vector<Vec3> vertices_on(const ProblemBody& body, const Face& own, const Face& other) {
  constexpr double kRoundOff = 1e-12;  // m: of positions that are sums of lengths
  std::vector<Vec3> found;
  const Eigen::Matrix3Xd& vertices = vertices_of(body);
  for (Eigen::Index v = 0; v < vertices.cols(); ++v) {
    const Vec3 p = body.position + vertices.col(v);
    bool inside = std::abs(p.x() - own.x) < kRoundOff;
    for (const int axis : {1, 2}) {
      inside =
          inside && p[axis] > other.low[axis] - kRoundOff && p[axis] < other.high[axis] + kRoundOff;
    }
    if (inside) found.push_back(p);
  }
  return found;
}

// Corners of the rectangle in which two faces overlap: where edges cross, no vertex need be.
void add_corners(const Face& one, const Face& other, std::vector<Vec3>& points) {
  const Vec3 low = one.low.cwiseMax(other.low), high = one.high.cwiseMin(other.high);
  for (const double y : {low.y(), high.y()}) {
    for (const double z : {low.z(), high.z()}) {
      const Vec3 corner(one.x, y, z);
      const bool known = std::any_of(points.begin(), points.end(),
                                     [&](const Vec3& p) { return (p - corner).norm() < 1e-9; });
      if (!known) points.push_back(corner);
    }
  }
}

}  // namespace

reference::LimitProblem clamp_points(const ClampSetup& setup, double force) {
  const Problem problem = clamp_problem(setup);
  const auto boxes = static_cast<std::size_t>(setup.boxes);
  reference::LimitProblem limit;
  limit.gravity.setZero();
  limit.live_gravity = Vec3(0.0, 0.0, -setup.fall);
  for (std::size_t b = 0; b < boxes; ++b) {
    limit.bodies.push_back({setup.box_mass, problem.bodies[b].position});
  }
  reference::PrescribedNormalForce left{{}, force};
  for (std::size_t joint = 0; joint <= boxes; ++joint) {
    // Left and right of the joint; a jaw is a bar or, rigid, a half-space without edges.
    const bool at_left = joint == 0, at_right = joint == boxes;
    const bool plane = setup.rigid && (at_left || at_right);
    const Face everywhere{0.0, Vec3::Constant(-INFINITY), Vec3::Constant(INFINITY)};
    const ProblemBody* before =
        at_left ? (plane ? nullptr : &problem.bodies[boxes]) : &problem.bodies[joint - 1];
    const ProblemBody* after =
        at_right ? (plane ? nullptr : &problem.bodies[boxes + 1]) : &problem.bodies[joint];
    const Face right_of_before = before ? face_of(*before, 1.0) : everywhere;
    const Face left_of_after = after ? face_of(*after, -1.0) : everywhere;
    std::vector<Vec3> points;
    if (before) points = vertices_on(*before, right_of_before, left_of_after);
    if (after) {
      for (const Vec3& p : vertices_on(*after, left_of_after, right_of_before)) points.push_back(p);
    }
    if (before && after) add_corners(right_of_before, left_of_after, points);
    for (const Vec3& p : points) {
      if (at_left) left.contacts.push_back(static_cast<int>(limit.contacts.size()));
      // The jaws are fixed, so that the box is `body_a` and the normal points into it.
      const int a = at_right ? static_cast<int>(joint) - 1 : static_cast<int>(joint);
      const int b = at_left || at_right ? reference::kFixed : static_cast<int>(joint) - 1;
      limit.contacts.push_back({a, b, p, at_right ? Vec3(-Vec3::UnitX()) : Vec3::UnitX(), 1.0});
    }
  }
  limit.clamps = {left};  // that of the right jaw follows from equilibrium
  return limit;
}

ClampLimit clamp_limit(const ClampSetup& setup) {
  // Force and load are proportional: what carries λ weights at this force needs a λ-th of it.
  const double force = setup.boxes * setup.box_mass * setup.fall / setup.friction;
  const reference::LimitBracket load =
      reference::critical_load(clamp_points(setup, force), setup.friction);
  return {force / load.upper, force / load.lower};
}

}  // namespace stiction
