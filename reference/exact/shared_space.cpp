// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact/shared_space.h"

#include <CGAL/box_intersection_d.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/exact/kernels.h"

namespace stiction::reference {

namespace {

using Eigen::Vector3d;

struct Piece {
  FilteredKernel::Tetrahedron_3 tetrahedron;
  bool held = false;
};

// Each tetrahedron with its faces moved inwards by `inset`, towards the centre of its inscribed ball;
// those that have no more inside are left out.
std::vector<Piece> pieces_of(const SolidMesh& solid, double inset) {
  std::vector<Piece> pieces;
  const TetMesh& mesh = solid.mesh;
  for (Eigen::Index e = 0; e < mesh.tetrahedra.cols(); ++e) {
    Vector3d x[4];
    bool held = !solid.held.empty();
    for (int k = 0; k < 4; ++k) {
      const int v = mesh.tetrahedra(k, e);
      x[k] = mesh.vertices.col(v);
      held = held && solid.held[static_cast<std::size_t>(v)];
    }
    const double volume = (x[1] - x[0]).cross(x[2] - x[0]).dot(x[3] - x[0]) / 6.0;
    if (volume < 0.0) std::swap(x[0], x[1]);
    double area[4], whole = 0.0;
    Vector3d centre = Vector3d::Zero();
    for (int k = 0; k < 4; ++k) {
      const Vector3d &a = x[(k + 1) % 4], &b = x[(k + 2) % 4], &c = x[(k + 3) % 4];
      area[k] = 0.5 * (b - a).cross(c - a).norm();
      whole += area[k];
    }
    const double inradius = 3.0 * std::abs(volume) / whole;
    if (!(inradius > inset)) continue;
    for (int k = 0; k < 4; ++k) centre += area[k] / whole * x[k];
    for (Vector3d& corner : x) corner += inset / inradius * (centre - corner);
    pieces.push_back({{filtered(x[0]), filtered(x[1]), filtered(x[2]), filtered(x[3])}, held});
  }
  return pieces;
}

using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const Piece*>;

std::vector<Box> boxes_of(const std::vector<Piece>& pieces) {
  std::vector<Box> boxes;
  for (const Piece& piece : pieces) boxes.emplace_back(piece.tetrahedron.bbox(), &piece);
  return boxes;
}

bool share(const SolidMesh& a, const SolidMesh& b, double inset) {
  const std::vector<Piece> of_a = pieces_of(a, inset), of_b = pieces_of(b, inset);
  std::vector<Box> boxes_a = boxes_of(of_a), boxes_b = boxes_of(of_b);
  bool found = false;
  const auto meet = [&](const Box& one, const Box& other) {
    const Piece &p = *one.handle(), &q = *other.handle();
    if (found || (p.held && q.held)) return;
    found = CGAL::do_intersect(p.tetrahedron, q.tetrahedron);
  };
  CGAL::box_intersection_d(boxes_a.begin(), boxes_a.end(), boxes_b.begin(), boxes_b.end(), meet);
  return found;
}

bool share(const SolidMesh& a, const SolidBall& b, double inset) {
  const double reach = b.radius - inset;
  if (!(reach > 0.0)) return false;
  const std::vector<Piece> pieces = pieces_of(a, inset);
  return std::any_of(pieces.begin(), pieces.end(), [&](const Piece& piece) {
    return CGAL::squared_distance(filtered(b.centre), piece.tetrahedron) < reach * reach;
  });
}

bool share(const SolidMesh& a, const SolidPoint& b, double inset) {
  const std::vector<Piece> pieces = pieces_of(a, inset);
  return std::any_of(pieces.begin(), pieces.end(), [&](const Piece& piece) {
    return piece.tetrahedron.has_on_bounded_side(filtered(b.position));
  });
}

bool share(const SolidBall& a, const SolidBall& b, double inset) {
  return (a.centre - b.centre).norm() < a.radius + b.radius - 2.0 * inset;
}

bool share(const SolidBall& a, const SolidPoint& b, double inset) {
  return (a.centre - b.position).norm() < a.radius - inset;
}

bool share(const SolidPoint&, const SolidPoint&, double) { return false; }

bool share(const SolidBall& a, const SolidMesh& b, double inset) { return share(b, a, inset); }
bool share(const SolidPoint& a, const SolidMesh& b, double inset) { return share(b, a, inset); }
bool share(const SolidPoint& a, const SolidBall& b, double inset) { return share(b, a, inset); }

bool share_space(const Solid& a, const Solid& b, double inset) {
  return std::visit([&](const auto& x, const auto& y) { return share(x, y, inset); }, a, b);
}

struct Bounds {
  Vector3d operator()(const SolidMesh& solid) const {
    if (low) return solid.mesh.vertices.rowwise().minCoeff();
    return solid.mesh.vertices.rowwise().maxCoeff();
  }
  Vector3d operator()(const SolidBall& ball) const {
    return ball.centre + Vector3d::Constant(low ? -ball.radius : ball.radius);
  }
  Vector3d operator()(const SolidPoint& point) const { return point.position; }
  bool low;
};

// The greatest inset at which they still meet, to a tenth.
double depth_of(const Solid& a, const Solid& b, double allowed) {
  double yes = allowed, no = allowed;
  do {
    no *= 2.0;
    if (!share_space(a, b, no)) break;
    yes = no;
  } while (no < 1e30);
  while (no > 1.1 * yes) {
    const double middle = std::sqrt(yes * no);
    (share_space(a, b, middle) ? yes : no) = middle;
  }
  return yes;
}

}  // namespace

std::optional<SharedSpace> shared_space(const std::vector<Solid>& solids, double allowed) {
  using BodyBox = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const Solid*>;
  std::vector<BodyBox> boxes;
  for (const Solid& solid : solids) {
    const Vector3d low = std::visit(Bounds{true}, solid), high = std::visit(Bounds{false}, solid);
    boxes.emplace_back(CGAL::Bbox_3(low.x(), low.y(), low.z(), high.x(), high.y(), high.z()),
                       &solid);
  }
  std::optional<SharedSpace> found;
  CGAL::box_self_intersection_d(
      boxes.begin(), boxes.end(), [&](const BodyBox& one, const BodyBox& other) {
        if (found || !share_space(*one.handle(), *other.handle(), allowed)) return;
        const auto a = static_cast<std::size_t>(one.handle() - solids.data());
        const auto b = static_cast<std::size_t>(other.handle() - solids.data());
        found = {std::min(a, b), std::max(a, b), depth_of(*one.handle(), *other.handle(), allowed)};
      });
  return found;
}

}  // namespace stiction::reference
