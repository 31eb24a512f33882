// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact/exact_consistent_depth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <vector>

#include "reference/exact/exact_detection.h"
#include "reference/exact/kernels.h"

namespace stiction::reference {

namespace {

using RationalPoint = RationalKernel::Point_3;
using RationalVector = RationalKernel::Vector_3;
using Real = boost::multiprecision::mpf_float_50;
using RealVector = std::array<Real, 3>;
using Eigen::Index;
using Eigen::Vector3d;

constexpr double kCancelled = 1e-12;

Real real(const Exact& q) { return Real(q.mpq()); }
RealVector real(const RationalVector& v) { return {real(v.x()), real(v.y()), real(v.z())}; }

Real real_dot(const RealVector& a, const RealVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Real length(const RealVector& a) { return sqrt(real_dot(a, a)); }

void add(RealVector& sum, const Real& weight, const RealVector& v) {
  for (std::size_t k = 0; k < 3; ++k) sum[k] += weight * v[k];
}

struct Triangle {
  std::array<RationalPoint, 3> corner;
  RationalVector normal;  // not normalised
  Eigen::AlignedBox3d box;
};

struct Crossing {
  Exact t;
  std::vector<std::pair<const Triangle*, std::array<bool, 3>>> on;  // and which edges are touched
};

// Angle of the triangle around a point of it: 2π inside, π on an edge.
Real angle_around(const Triangle& triangle, const std::array<bool, 3>& touched) {
  const Real pi = acos(Real(-1));
  const int count = touched[0] + touched[1] + touched[2];
  if (count == 0) return 2 * pi;
  if (count == 1) return pi;
  // Edge k leads from corner k to the next; two that are touched meet in a corner.
  const std::size_t at = !touched[0] ? 2 : !touched[1] ? 0 : 1;
  const RealVector one = real(triangle.corner[(at + 1) % 3] - triangle.corner[at]);
  const RealVector other = real(triangle.corner[(at + 2) % 3] - triangle.corner[at]);
  return acos(real_dot(one, other) / (length(one) * length(other)));
}

// Where the segment p → q first leaves through one of the triangles.
std::optional<Crossing> first_crossing(const std::vector<Triangle>& triangles, const Vector3d& from,
                                       const Vector3d& to) {
  const RationalPoint p = rational(from), q = rational(to);
  Eigen::AlignedBox3d box(from);
  box.extend(to);
  std::optional<Crossing> first;
  for (const Triangle& triangle : triangles) {
    if (!box.intersects(triangle.box)) continue;  // comparisons of doubles are exact
    const Exact below = triangle.normal * (p - triangle.corner[0]);
    const Exact above = triangle.normal * (q - triangle.corner[0]);
    if (!(below <= 0 && above > 0)) continue;
    std::array<bool, 3> touched = {};
    bool meets = true;
    for (std::size_t k = 0; k < 3 && meets; ++k) {
      const Exact side =
          (q - p) * CGAL::cross_product(triangle.corner[k] - p, triangle.corner[(k + 1) % 3] - p);
      meets = side >= 0;
      touched[k] = side == 0;
    }
    if (!meets) continue;
    const Exact t = below / (below - above);
    if (!first || t < first->t) first = Crossing{t, {}};
    if (t == first->t) first->on.emplace_back(&triangle, touched);
  }
  return first;
}

RealVector normal_of(const Crossing& crossing) {
  RealVector sum = {};
  for (const auto& [triangle, touched] : crossing.on) {
    const RealVector normal = real(triangle->normal);
    add(sum, angle_around(*triangle, touched) / length(normal), normal);
  }
  const Real size = length(sum);
  for (Real& x : sum) x /= size;
  return sum;
}

// One of the things that a mean is of.
struct Sample {
  Real weight, depth;
  RealVector normal;
  double moved, turned, weight_off;  // per metre: of depth, of normal, of weight over weight
  double agreement;
};

struct Known {
  int level;
  Real depth;
  RealVector normal;
  double moved, turned, agreement;
};

double rounded(const Real& x) { return x.convert_to<double>(); }

std::optional<Known> mean(const std::vector<Sample>& samples, int level) {
  Real weight = 0, depth = 0;
  RealVector normal = {};
  for (const Sample& sample : samples) {
    weight += sample.weight;
    depth += sample.weight * sample.depth;
    add(normal, sample.weight, sample.normal);
  }
  const Real size = length(normal);
  if (!(weight > 0) || !(size > kCancelled * weight)) return {};
  depth /= weight;
  Known result{level, depth > 0 ? depth : Real(0), normal, 0.0, 0.0, 1.0};
  for (Real& x : result.normal) x /= size;
  // d = Σ w d_i / Σ w changes by Σ (w_i/Σ w) (δd_i + (d_i − d) δw_i/w_i); the direction likewise,
  // by what is across it.
  for (const Sample& sample : samples) {
    const double share = rounded(sample.weight / weight);
    RealVector across = sample.normal;
    add(across, -real_dot(sample.normal, result.normal), result.normal);
    result.moved += share * (sample.moved + rounded(abs(sample.depth - depth)) * sample.weight_off);
    result.turned += share * (sample.turned + rounded(length(across)) * sample.weight_off);
    result.agreement = std::min(result.agreement, sample.agreement);
  }
  const double agreement = rounded(size / weight);
  result.turned /= agreement;
  result.agreement *= agreement;
  return result;
}

std::vector<std::set<Index>> neighbours(const TetMesh& mesh) {
  std::vector<std::set<Index>> of(static_cast<std::size_t>(mesh.vertices.cols()));
  for (const auto& corners : mesh.tetrahedra.colwise()) {
    for (const Index a : corners) {
      for (const Index b : corners) {
        if (a != b) of[static_cast<std::size_t>(a)].insert(b);
      }
    }
  }
  return of;
}

std::vector<Triangle> triangles_of(const ExactBody& body, const TetMesh& mesh) {
  std::vector<Triangle> triangles;
  for (const auto& corners : body.surface().colwise()) {
    Triangle triangle;
    for (Index k = 0; k < 3; ++k) {
      const Vector3d x = mesh.vertices.col(corners[k]);
      triangle.corner[static_cast<std::size_t>(k)] = rational(x);
      triangle.box.extend(x);
    }
    triangle.normal = CGAL::cross_product(triangle.corner[1] - triangle.corner[0],
                                          triangle.corner[2] - triangle.corner[0]);
    triangles.push_back(triangle);
  }
  return triangles;
}

}  // namespace

std::vector<ConsistentDepth> exact_consistent_depths(const TetMesh& body, const TetMesh& penetrated,
                                                     double softening) {
  if (!(softening > 0.0 && std::isfinite(softening))) {
    throw std::invalid_argument("exact consistent depth: the softening is a positive length");
  }
  const ExactBody own(body), other(penetrated);
  const std::vector<Triangle> triangles = triangles_of(other, penetrated);
  const std::vector<std::set<Index>> joined = neighbours(body);
  const auto at = [&](Index v) -> Vector3d { return body.vertices.col(v); };
  std::set<Index> inside;
  for (const Index v : own.surface().reshaped()) {
    if (!inside.count(v) && !other.tetrahedra_at(at(v)).empty()) inside.insert(v);
  }
  std::map<Index, Known> reached;
  for (const Index v : inside) {
    std::vector<Sample> samples;
    for (const Index w : joined[static_cast<std::size_t>(v)]) {
      const std::optional<Crossing> crossing = first_crossing(triangles, at(v), at(w));
      if (!crossing) continue;
      const RationalVector edge = rational(at(w)) - rational(at(v));
      const RationalVector away = crossing->t * edge;
      const Real away2 = real(away * away + Exact(softening) * Exact(softening));
      const RealVector normal = normal_of(*crossing);
      const double slope = rounded(real_dot(real(edge), normal) / length(real(edge)));
      samples.push_back({1 / away2, real_dot(real(away), normal), normal, 1.0, 0.0,
                         2.0 / (rounded(sqrt(away2)) * slope), 1.0});
    }
    if (const auto found = mean(samples, 1)) reached.emplace(v, *found);
  }
  for (int level = 2;; ++level) {
    std::map<Index, Known> next;
    for (const Index v : inside) {
      if (reached.count(v)) continue;
      std::vector<Sample> samples;
      for (const Index w : joined[static_cast<std::size_t>(v)]) {
        const auto from = reached.find(w);
        if (from == reached.end()) continue;
        const Known& k = from->second;
        const RationalVector away = rational(at(w)) - rational(at(v));
        const Real away2 = real(away * away);
        samples.push_back({1 / away2, real_dot(real(away), k.normal) + k.depth, k.normal,
                           k.moved + rounded(sqrt(away2)) * k.turned, k.turned, 0.0, k.agreement});
      }
      if (const auto found = mean(samples, level)) next.emplace(v, *found);
    }
    if (next.empty()) break;
    reached.merge(next);
  }
  std::vector<ConsistentDepth> result;
  for (const Index v : inside) {
    ConsistentDepth depth;
    depth.vertex = v;
    if (const auto found = reached.find(v); found != reached.end()) {
      const Known& k = found->second;
      depth.level = k.level;
      depth.depth = rounded(k.depth);
      for (Index c = 0; c < 3; ++c) {
        depth.normal[c] = rounded(k.normal[static_cast<std::size_t>(c)]);
      }
      depth.moved = k.moved;
      depth.turned = k.turned;
      depth.agreement = k.agreement;
    }
    result.push_back(depth);
  }
  return result;
}

}  // namespace stiction::reference
