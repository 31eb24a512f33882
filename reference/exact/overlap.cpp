// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact/overlap.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "reference/exact/kernels.h"

namespace stiction::reference {

namespace {

// Depths up to this part of what is allowed are less than that, whatever the rounding.
constexpr double kNearly = 0.999;

using Triangles = std::vector<FilteredKernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<FilteredKernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<FilteredKernel, Primitive>>;
using Eigen::Vector3d;

Vector3d vector(const FilteredKernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

Triangles triangles_of(const Skin& skin) {
  Triangles all;
  for (Eigen::Index t = 0; t < skin.triangles().cols(); ++t) {
    const auto corner = [&](int k) {
      return filtered(skin.vertices().col(skin.triangles()(k, t)));
    };
    const FilteredKernel::Triangle_3 triangle(corner(0), corner(1), corner(2));
    if (!triangle.is_degenerate()) all.push_back(triangle);
  }
  return all;
}

}  // namespace

class ClosedSolid {
 public:
  explicit ClosedSolid(const Skin& skin)
      : triangles_(triangles_of(skin)), tree_(triangles_.begin(), triangles_.end()) {}

  // A ray leaves a closed surface once more often than it enters, if it starts inside. One that
  // meets an edge counts it twice; of three in directions that no mesh has, two agree.
  bool holds(const Vector3d& x) const {
    static const FilteredKernel::Vector_3 ways[3] = {{0.5432917, 0.3917351, 0.7424113},
                                                     {-0.6113971, 0.7712345, -0.1771929},
                                                     {0.2911743, -0.8341197, 0.4685231}};
    const auto says_inside = [&](int k) {
      return tree_.number_of_intersected_primitives(FilteredKernel::Ray_3(filtered(x), ways[k])) %
                 2 ==
             1;
    };
    const bool first = says_inside(0);
    return says_inside(1) == first ? first : says_inside(2);
  }

  double distance(const Vector3d& x) const {
    return std::sqrt(tree_.squared_distance(filtered(x)));
  }

  // Where the way from a to b meets the surface: shares of it, ascending, with 0 and 1. Which
  // triangles it meets is decided exactly; CGAL's own construction of the points stops the program
  // where rounding contradicts that.
  std::vector<double> crossings(const Vector3d& a, const Vector3d& b) const {
    std::vector<double> shares = {0.0, 1.0};
    for (const FilteredKernel::Triangle_3& triangle :
         met(FilteredKernel::Segment_3(filtered(a), filtered(b)))) {
      shares.push_back(std::clamp(share(triangle, a, b - a), 0.0, 1.0));
    }
    std::sort(shares.begin(), shares.end());
    return shares;
  }

  // From a point of the surface straight in to where the way out is; `none` when it isn't.
  double way_through(const Vector3d& from, const Vector3d& into, double none) const {
    double nearest = none;
    const FilteredKernel::Vector_3 way(into.x(), into.y(), into.z());
    for (const FilteredKernel::Triangle_3& triangle :
         met(FilteredKernel::Ray_3(filtered(from), way))) {
      const double length = share(triangle, from, into) * into.norm();
      if (length > 1e-9 * none) nearest = std::min(nearest, length);
    }
    return nearest;
  }

 private:
  template <class Query>
  Triangles met(const Query& query) const {
    std::vector<Tree::Primitive_id> found;
    tree_.all_intersected_primitives(query, std::back_inserter(found));
    Triangles all;
    for (const auto& id : found) all.push_back(*id);
    return all;
  }

  // Where a + s way meets the triangle's plane; 0 when it lies in it, and so on the surface.
  static double share(const FilteredKernel::Triangle_3& triangle, const Vector3d& a,
                      const Vector3d& way) {
    const Vector3d corner = vector(triangle[0]);
    const Vector3d normal =
        (vector(triangle[1]) - corner).cross(vector(triangle[2]) - corner).normalized();
    const double nearing = normal.dot(way);
    return nearing == 0.0 ? 0.0 : normal.dot(corner - a) / nearing;
  }

  Triangles triangles_;
  Tree tree_;
};

namespace {

// Whether a plane shows that no point of `inner` is deeper than `allowed` in `outer`: as far as that beyond
// the plane there is nothing of `outer`, and of `inner` all. Between bodies that touch by faces that are
// nearly flat, one of a face does, or one across the way between their middles.
bool is_apart(const Skin& inner, const Skin& outer, double allowed) {
  constexpr int kMost = 64;            // directions that are tried
  constexpr double kAlike = 0.9998;    // cosine of 1.1°: nothing new beside one that was tried
  constexpr double kRounding = 1e-14;  // of a product with a direction, in parts of its terms
  double size = allowed;
  for (const Skin* skin : {&inner, &outer}) {
    size = std::max({size, skin->high().cwiseAbs().maxCoeff(), skin->low().cwiseAbs().maxCoeff()});
  }
  std::vector<Vector3d> tried;
  const auto separates = [&](const Vector3d& way) {
    const double length = way.norm();
    if (!(length > 0.0) || tried.size() == kMost) return false;
    const Vector3d n = way / length;
    for (const Vector3d& other : tried) {
      if (n.dot(other) > kAlike) return false;
    }
    tried.push_back(n);
    double top = -std::numeric_limits<double>::infinity(), bottom = -top;
    for (const int v : outer.used()) top = std::max(top, n.dot(outer.vertices().col(v)));
    for (const int v : inner.used()) {
      bottom = std::min(bottom, n.dot(inner.vertices().col(v)));
      if (bottom + allowed < top) return false;
    }
    return bottom + allowed > top + kRounding * size;
  };
  if (separates(inner.low() + inner.high() - outer.low() - outer.high())) return true;
  for (const bool is_inner : {false, true}) {
    const Skin& skin = is_inner ? inner : outer;
    for (Eigen::Index t = 0; t < skin.triangles().cols(); ++t) {
      const auto corner = [&](int k) { return skin.vertices().col(skin.triangles()(k, t)); };
      const Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
      if (separates(is_inner ? Vector3d(-normal) : normal)) return true;
    }
  }
  return false;
}

// Whether the way from a to b touches the box.
bool meets_box(const Vector3d& a, const Vector3d& b, const Vector3d& low, const Vector3d& high) {
  double from = 0.0, to = 1.0;
  for (int k = 0; k < 3; ++k) {
    const double way = b[k] - a[k];
    if (way == 0.0) {
      if (a[k] < low[k] || a[k] > high[k]) return false;
      continue;
    }
    const double one = (low[k] - a[k]) / way, other = (high[k] - a[k]) / way;
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
  }
  return from <= to;
}

}  // namespace

Skin::Skin(Eigen::Matrix3Xi triangles, Eigen::Matrix3Xd vertices)
    : triangles_(std::move(triangles)) {
  for (Eigen::Index t = 0; t < triangles_.cols(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int a = triangles_(k, t), b = triangles_((k + 1) % 3, t);
      edges_.emplace_back(std::min(a, b), std::max(a, b));
      used_.push_back(a);
    }
  }
  std::sort(edges_.begin(), edges_.end());
  edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  std::sort(used_.begin(), used_.end());
  used_.erase(std::unique(used_.begin(), used_.end()), used_.end());
  move(std::move(vertices));
}

void Skin::move(Eigen::Matrix3Xd vertices) {
  vertices_ = std::move(vertices);
  solid_.reset();
  low_.setConstant(std::numeric_limits<double>::infinity());
  high_ = -low_;
  for (const int v : used_) {
    low_ = low_.cwiseMin(vertices_.col(v));
    high_ = high_.cwiseMax(vertices_.col(v));
  }
}

const ClosedSolid& Skin::solid() const {
  if (!solid_) solid_ = std::make_shared<const ClosedSolid>(*this);
  return *solid_;
}

double Skin::thickness() const {
  const double diagonal = (high_ - low_).norm();
  std::vector<std::pair<double, double>> ways;  // and areas
  double area = 0.0;
  const Eigen::Index stride = 1 + (triangles_.cols() - 1) / kThicknessSamples;
  for (Eigen::Index t = 0; t < triangles_.cols(); t += stride) {
    const Vector3d a = vertices_.col(triangles_(0, t)), b = vertices_.col(triangles_(1, t)),
                   c = vertices_.col(triangles_(2, t));
    const Vector3d normal = (b - a).cross(c - a);  // twice the area
    if (!(normal.norm() > 0.0)) continue;
    ways.emplace_back(solid().way_through((a + b + c) / 3.0, -normal.normalized(), diagonal),
                      normal.norm());
    area += normal.norm();
  }
  std::sort(ways.begin(), ways.end());
  double seen = 0.0;
  for (const auto& [way, share] : ways) {
    seen += share;
    if (seen >= 0.1 * area) return way;
  }
  return diagonal;
}

std::optional<Overlap> deepest(const Skin& inner, const Skin& outer, double allowed) {
  // What is deeper than `allowed` lies as deep in the bounding box.
  const Vector3d low = outer.low().array() + allowed, high = outer.high().array() - allowed;
  if ((low.array() > high.array()).any() || (inner.low().array() > high.array()).any() ||
      (inner.high().array() < low.array()).any()) {
    return std::nullopt;
  }
  if (is_apart(inner, outer, allowed)) return std::nullopt;
  const Eigen::Matrix3Xd& x = inner.vertices();
  std::optional<Overlap> worst;
  const auto note = [&](const Vector3d& at) {
    const double depth = outer.solid().distance(at);
    if (depth > allowed && (!worst || depth > worst->depth)) worst = {depth, at, false};
  };
  const auto in_box = [&](const Vector3d& at) {
    return (at.array() >= low.array()).all() && (at.array() <= high.array()).all();
  };
  struct Crossed {
    int a, b;
    std::vector<double> shares;
  };
  std::vector<Crossed> crossed;
  // Ends of an edge that meets no triangle are both inside or both outside, and so on along such edges.
  std::vector<int> as(static_cast<std::size_t>(x.cols()));
  std::iota(as.begin(), as.end(), 0);
  const auto first_as = [&](int v) {
    const auto next = [&](int of) -> int& { return as[static_cast<std::size_t>(of)]; };
    while (next(v) != v) v = next(v) = next(next(v));
    return v;
  };
  for (const auto& [a, b] : inner.edges()) {
    if (!meets_box(x.col(a), x.col(b), low, high)) continue;
    crossed.push_back({a, b, outer.solid().crossings(x.col(a), x.col(b))});
    if (crossed.back().shares.size() == 2) as[static_cast<std::size_t>(first_as(a))] = first_as(b);
  }
  std::vector<std::optional<bool>> held(as.size());
  const auto holds = [&](int v) {
    std::optional<bool>& known = held[static_cast<std::size_t>(first_as(v))];
    if (!known) known = outer.solid().holds(x.col(v));
    return *known;
  };
  for (const int v : inner.used()) {
    if (in_box(x.col(v)) && holds(v)) note(x.col(v));
  }
  for (const auto& [a, b, shares] : crossed) {
    const bool meets = shares.size() > 2;
    if (!meets && !holds(a)) continue;  // it is outside, and so is all of the edge
    const double length = (x.col(b) - x.col(a)).norm();
    for (std::size_t k = 0; k + 1 < shares.size(); ++k) {
      // The surface is no farther than an end of the stretch, where it is met.
      if (meets && 0.5 * (shares[k + 1] - shares[k]) * length < kNearly * allowed) continue;
      const Vector3d middle = x.col(a) + 0.5 * (shares[k] + shares[k + 1]) * (x.col(b) - x.col(a));
      if (!in_box(middle)) continue;
      const double before = worst ? worst->depth : 0.0;
      if (outer.solid().holds(middle)) note(middle);
      if (worst && worst->depth > before) worst->by_an_edge = !holds(a) && !holds(b);
    }
  }
  return worst;
}

}  // namespace stiction::reference
