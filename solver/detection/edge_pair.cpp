// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/edge_pair.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "solver/depth/nearest_face.h"

namespace stiction {

namespace {

const Vec3& at(const std::vector<Vec3>& x, std::int32_t v) {
  return x[static_cast<std::size_t>(v)];
}

// An edge with what bounds ask of it.
struct Edge {
  const Topology::SharpEdge& sharp;
  const std::vector<Vec3>& x;
  EdgeFrame frame;
  Vec3 along;  // unit

  Edge(const Topology& topology, const std::vector<Vec3>& positions, std::int32_t e)
      : sharp(topology.sharp_edge[static_cast<std::size_t>(e)]),
        x(positions),
        frame(frame_of(positions, sharp)),
        along((end(1) - end(0)) / frame.length) {}

  const Vec3& end(int k) const { return at(x, sharp.vertex[k]); }
  // Of it and of the triangles beside it, m.
  Real least_height() const {
    Real least = frame.length;
    for (const std::int32_t v : sharp.opposite) {
      least = std::min(least, stiction::least_height(end(0), end(1), at(x, v)));
    }
    return least;
  }
};

// While nothing moves by more than a share σ of the edges' lengths, the sine of their angle φ changes
// by no more than both turn together, 2.02 σ.
Real parallel_within(Real sine, const Edge& a, const Edge& b) {
  constexpr Real kShare = 0.01, kChange = 0.03;
  return sine < kParallel - kChange ? kShare * std::min(a.frame.length, b.frame.length) : 0;
}

// The crossing stands s from an end of an edge:
//
//   s = w·(û − (û·v̂) v̂) / sin²φ,   w from that end to any point of the other's line,   û, v̂ along both
//
// When all moves by δ, w does, and û and v̂ turn by ε = 2.02 δ/l together, l the shorter edge. With
// ε ≤ sin φ/10 that moves s by no more than  1.24 δ (1.2 + 4.1 |w|/l + 4.3 |s|/l) / sin²φ. The δ by
// which s moves `by` so much, m.
Real crossing_moves(Real by, Real s, Real w, Real sine, Real shorter) {
  constexpr Real kSure = 1.5;
  const Real moves = kSure * (Real(1.2) * shorter + Real(4.1) * w + Real(4.3) * std::abs(s));
  return std::min(by * sine * sine * shorter / moves, sine * shorter / 21);
}

// While the crossing is beyond an end of `a`.
Real beyond_within(Real sine, const Edge& a, const Edge& b, Real along, const EndMargins& margins) {
  constexpr Real kLeastSine = 0.2;
  if (!(sine > kLeastSine)) return 0;
  const Real shorter = std::min(a.frame.length, b.frame.length);
  Real within = 0;
  for (int k = 0; k < 2; ++k) {
    const Real s = (k == 0 ? along : 1 - along) * a.frame.length;
    const Real beyond = (a.sharp.goes_on[k] ? margins.joint : margins.corner) - s;
    const Real w = (b.end(0) - a.end(k)).norm();
    within = std::max(within, crossing_moves(beyond, s, w, sine, shorter));
  }
  return within;
}

// While nothing moves by more than 0.02 of all lengths and heights, the normal of both edges turns by
// less than asin(0.041/sin φ), and the directions into the faces by less than 0.083.
constexpr Real kProductTurns = 0.2, kSumTurns = 0.4;  // by which products of them change
Real turns_little_within(const Edge& a, const Edge& b) {
  constexpr Real kShare = 0.02;
  return kShare * std::min(a.least_height(), b.least_height());
}

// The normal of both edges, out of b's body, where it is sure that it stays so.
std::optional<Vec3> sure_normal(Real sine, const Edge& a, const Edge& b) {
  constexpr Real kLeastSine = 0.5;
  if (!(sine > kLeastSine)) return {};
  const Vec3 normal = a.along.cross(b.along) / sine;
  const Real side = normal.dot(b.frame.into[0] + b.frame.into[1]);
  if (!(std::abs(side) > kSumTurns)) return {};
  return side > 0 ? Vec3(-normal) : normal;
}

Real turned_within(const Vec3& normal, const Edge& a, const Edge& b) {
  const Real of_a[2] = {normal.dot(a.frame.into[0]), normal.dot(a.frame.into[1])};
  const Real of_b[2] = {normal.dot(b.frame.into[0]), normal.dot(b.frame.into[1])};
  const bool turned = std::max(of_b[0], of_b[1]) > kBehind + kProductTurns ||
                      std::min(of_a[0], of_a[1]) < -kBehind - kProductTurns ||
                      of_a[0] + of_a[1] < -kSumTurns;
  return turned ? turns_little_within(a, b) : 0;
}

// While they stand off each other by more than `gap`: g = −n·(from a to b), which says on which side of b
// a is. Edges that are to touch cross within half their length of their ends (`meet`). Their points up to
// there move by no more than twice what the ends do, so that what is left between the edges so drawn out is
// at least g − 2δ. Nor can g have come to its other sign past them: where it is none the lines cross, and not
// there, so that the crossing would have had to come from where it is to beyond a half of one.
Real off_within(const Vec3& normal, Real sine, const Edge& a, const Edge& b, const LinePair& lines,
                const EdgeCrossing& crossing, Real gap) {
  const Real shorter = std::min(a.frame.length, b.frame.length), w = lines.between.norm();
  const auto stays = [&](const Edge& edge, Real along) {
    const Real room = (1 - std::abs(along - Real(0.5))) * edge.frame.length;
    return crossing_moves(room, along * edge.frame.length, w, sine, shorter);
  };
  return std::min({(-normal.dot(lines.between) - gap) / 2, turns_little_within(a, b),
                   stays(a, crossing.along_a), stays(b, crossing.along_b)});
}

}  // namespace

EdgeFrame frame_of(const std::vector<Vec3>& x, const Topology::SharpEdge& edge) {
  EdgeFrame frame;
  const Vec3 whole = at(x, edge.vertex[1]) - at(x, edge.vertex[0]);
  const Vec3 along = whole.normalized();
  frame.length = whole.norm();
  for (int face = 0; face < 2; ++face) {
    const Vec3 to = at(x, edge.opposite[face]) - at(x, edge.vertex[0]);
    frame.into[face] = (to - along.dot(to) * along).normalized();
  }
  return frame;
}

Real inside_ends(const Topology::SharpEdge& edge, Real length, Real along,
                 const EndMargins& margins) {
  const auto margin = [&](int end) { return edge.goes_on[end] ? margins.joint : margins.corner; };
  return std::min(along * length - margin(0), (1 - along) * length - margin(1));
}

bool meet(const Topology& topology, const std::vector<Vec3>& x, std::int32_t a, std::int32_t b,
          LinePair& lines, EdgeCrossing& crossing) {
  const auto& edge_a = topology.sharp_edge[static_cast<std::size_t>(a)];
  const auto& edge_b = topology.sharp_edge[static_cast<std::size_t>(b)];
  const Vec3 u = at(x, edge_a.vertex[1]) - at(x, edge_a.vertex[0]);
  const Vec3 v = at(x, edge_b.vertex[1]) - at(x, edge_b.vertex[0]);
  const Vec3 across = u.cross(v);
  const Real across2 = across.squaredNorm();
  if (!(across2 > kParallel * kParallel * u.squaredNorm() * v.squaredNorm())) return false;
  const Vec3 between = at(x, edge_b.vertex[0]) - at(x, edge_a.vertex[0]);
  crossing.along_a = between.cross(v).dot(across) / across2;
  crossing.along_b = between.cross(u).dot(across) / across2;
  lines = {between, across, across2};
  return !(std::abs(crossing.along_a - Real(0.5)) > 1.0 ||
           std::abs(crossing.along_b - Real(0.5)) > 1.0);
}

bool face(const LinePair& lines, const EdgeFrame& a, const EdgeFrame& b, EdgeCrossing& crossing) {
  crossing.normal = lines.across / std::sqrt(lines.across2);
  if (crossing.normal.dot(b.into[0] + b.into[1]) > 0.0) crossing.normal = -crossing.normal;
  const auto before = [&](const EdgeFrame& edge, int k) {
    return crossing.normal.dot(edge.into[k]);
  };
  if (std::max(before(b, 0), before(b, 1)) > kBehind) return false;
  if (crossing.normal.dot(a.into[0] + a.into[1]) <= 0.0 ||
      std::min(before(a, 0), before(a, 1)) < -kBehind) {
    return false;
  }
  crossing.gap = -crossing.normal.dot(lines.between);
  return true;
}

bool crossing_of(const Topology& topology, const std::vector<Vec3>& x, std::int32_t a,
                 std::int32_t b, EdgeCrossing& crossing) {
  LinePair lines;
  const auto frame = [&](std::int32_t e) {
    return frame_of(x, topology.sharp_edge[static_cast<std::size_t>(e)]);
  };
  return meet(topology, x, a, b, lines, crossing) && face(lines, frame(a), frame(b), crossing);
}

Real apart_within(const Topology& topology, const std::vector<Vec3>& x, std::int32_t a,
                  std::int32_t b, const EndMargins& margins, Real gap) {
  const Edge edge_a(topology, x, a), edge_b(topology, x, b);
  const Real sine = edge_a.along.cross(edge_b.along).norm();
  LinePair lines;
  EdgeCrossing crossing;
  if (const Real within = parallel_within(sine, edge_a, edge_b); within > 0) return within;
  if (!(sine > 2 * kParallel)) return 0;
  meet(topology, x, a, b, lines, crossing);
  Real within = std::max(beyond_within(sine, edge_a, edge_b, crossing.along_a, margins),
                         beyond_within(sine, edge_b, edge_a, crossing.along_b, margins));
  if (const auto normal = sure_normal(sine, edge_a, edge_b)) {
    within = std::max({within, turned_within(*normal, edge_a, edge_b),
                       off_within(*normal, sine, edge_a, edge_b, lines, crossing, gap)});
  }
  return within;
}

}  // namespace stiction
