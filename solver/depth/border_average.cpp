// SPDX-License-Identifier: BSD-3-Clause
#include "solver/depth/border_average.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>

#include "solver/depth/edge_exit.h"
#include "solver/lanes/in_registers.h"
#include "solver/lanes/lane_geometry.h"

namespace stiction {

namespace {

// Normals whose mean is this short cancel out: its direction would be rounding.
constexpr Real kCancelled = by_precision(1e-12, 1e-5);

void add_walk(const Border& border, std::int32_t neighbour, WalkScratch& scratch,
              Average& average) {
  const Vec3 &p = border.at(), &q = border.x[static_cast<std::size_t>(neighbour)];
  Exit exit;
  if (!find_exit(border.scene, border.links, border.x, p, q, border.element, border.thin, scratch,
                 exit)) {
    return;
  }
  const Vec3 away = exit.t * (q - p);
  average.add(1 / (away.squaredNorm() + border.thin * border.thin), away.dot(exit.normal),
              exit.normal);
}

// What edges of a vertex add to the mean: a bit each in the order of its neighbours.
struct Leaving {
  static constexpr int kRoom = Outlets::kMostEdges + kMostLanes;
  std::uint32_t leave = 0;   // or may
  std::uint32_t unsure = 0;  // of these, what takes a walk to know
  Real weight[kRoom];
  FourNumbers times_weight[kRoom];  // normal and depth
};

template <class Number>
STICTION_LANES_INLINE LaneVector<Number> in_all_lanes(const Vec3& a) {
  return {Number(a.x()), Number(a.y()), Number(a.z())};
}

// The sum of sizes (of single vectors lpNorm<1>), which is no less than the length and takes no root.
template <class Number>
STICTION_LANES_INLINE Number sum_of_sizes(const LaneVector<Number>& a) {
  return greater(a.x, -a.x) + greater(a.y, -a.y) + greater(a.z, -a.z);
}

// Times what `find_exit` takes for touching, at least: heights and sides have the bits that they have there,
// and what is farther off than this it doesn't take for that.
constexpr Real kOver = 2;

// Of as many edges as there are lanes, from the `first` on; each as `find_exit` and `add_walk` do, with their bits.
template <int Bytes>
STICTION_LANES_INLINE void leave_by_outlets(const Border& border, const Outlets& outlets,
                                            std::size_t first, Leaving& leaving) {
  using Number = Lanes<Bytes>;
  using Mask = typename Number::Mask;
  const auto neighbours = border.neighbours();
  const LaneVector<Number> q = at_vertices<Number>(border.x, [&](int lane) {
    return neighbours[std::min(first + static_cast<std::size_t>(lane), neighbours.size() - 1)];
  });
  const Vec3& p = border.at();
  const LaneVector<Number> along = q - in_all_lanes<Number>(p);
  const Number zero(Real(0)), one(Real(1)), thin(border.thin);
  const Number far = sum_of_sizes(along);
  Number t = zero;
  LaneVector<Number> normal{zero, zero, zero};
  Mask leaves = Mask::of(0), unsure = Mask::of(0);
  const Mask ends_outside = ~Mask::of(outlets.may_end_in >> first);
  for (int k = 0; k < outlets.count; ++k) {
    const Outlets::Outlet& outlet = outlets.outlet[static_cast<std::size_t>(k)];
    const unsigned asked = outlet.edges >> first;
    if (asked == 0) continue;
    const Topology::Triangle& triangle =
        border.scene.topology.triangle[static_cast<std::size_t>(outlet.triangle)];
    const auto& corner = triangle.vertex;
    const Vec3 &a = border.x[static_cast<std::size_t>(corner[0])],
               &b = border.x[static_cast<std::size_t>(corner[1])],
               &c = border.x[static_cast<std::size_t>(corner[2])];
    const Vec3 ab = b - a, ac = c - a, up = ab.cross(ac), pa = a - p, pb = b - p, pc = c - p;
    const Real p_height = up.dot(p - a), slack = kOver * border.thin * up.lpNorm<1>();
    if (!(p_height <= slack)) continue;
    const Number q_height = dot_as_eigen(in_all_lanes<Number>(up), q - in_all_lanes<Number>(a));
    // What may leave here, and what surely does.
    Mask may = Mask::of(asked) & (zero < q_height);
    if (none(may)) continue;
    Mask does = may & (Number(slack) < q_height);
    if (triangle.element != border.element) does = does & ends_outside;
    const Number touches = Number(kOver * border.thin * (ab.lpNorm<1>() + ac.lpNorm<1>())) * far;
    for (const Vec3& area : {pa.cross(pb), pb.cross(pc), pc.cross(pa)}) {
      const Number side = dot_as_eigen(along, in_all_lanes<Number>(area));
      may = may & (-touches <= side);
      does = does & (touches < side);
    }
    if (none(may)) continue;
    if (p_height > 0) does = Mask::of(0);
    unsure = unsure | (may & (leaves | ~does));
    leaves = leaves | may;
    if (none(does)) continue;
    const Number rise = choose(does, q_height - Number(p_height), one);
    t = choose(does, greater(zero, Number(-p_height) / rise), t);
    const Vec3 unit = up / up.norm();
    normal = {choose(does, Number(unit.x()), normal.x), choose(does, Number(unit.y()), normal.y),
              choose(does, Number(unit.z()), normal.z)};
  }
  if (none(leaves)) return;
  leaving.leave |= leaves.bits() << first;
  leaving.unsure |= unsure.bits() << first;
  const LaneVector<Number> away = t * along;
  const Number weight = one / (dot_as_eigen(away, away) + thin * thin);
  store_numbers(weight, &leaving.weight[first]);
  store_records(weight * normal.x, weight * normal.y, weight * normal.z,
                weight * dot_as_eigen(away, normal), &leaving.times_weight[first]);
}

}  // namespace

bool Average::write_to(PairContact& contact) const {
  const Real length = normal.norm();
  if (!(weight > 0.0) || !(length > kCancelled * weight)) return false;
  contact.depth = std::max(Real(0), depth / weight);
  contact.normal = normal / length;
  return true;
}

Average average_by_walks(const Border& border, WalkScratch& scratch) {
  Average average;
  for (const std::int32_t neighbour : border.neighbours()) {
    add_walk(border, neighbour, scratch, average);
  }
  return average;
}

Average average_by_outlets(const Border& border, const Outlets& outlets, int width,
                           WalkScratch& scratch) {
  const auto neighbours = border.neighbours();
  assert(neighbours.size() <= Outlets::kMostEdges);
  Leaving leaving;
  in_lanes(
      static_cast<int>(neighbours.size()), width, [&](auto bytes) __attribute__((always_inline)) {
        for (std::size_t k = 0; k < neighbours.size(); k += Lanes<bytes>::kCount) {
          leave_by_outlets<bytes>(border, outlets, k, leaving);
        }
      });
  Average average;
  for (std::uint32_t left = leaving.leave; left != 0; left &= left - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(left));
    if ((leaving.unsure >> k & 1U) != 0) {
      add_walk(border, neighbours[k], scratch, average);
      continue;
    }
    const FourNumbers& of = leaving.times_weight[k];
    average.weight += leaving.weight[k];
    average.depth += of[3];
    average.normal += Vec3(of[0], of[1], of[2]);
  }
  return average;
}

}  // namespace stiction
