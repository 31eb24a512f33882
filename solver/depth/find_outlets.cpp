// SPDX-License-Identifier: BSD-3-Clause
#include "solver/depth/find_outlets.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "solver/lanes/in_registers.h"

namespace stiction {

namespace {

// What may move, of the least altitude of an element; and at least, of ε: that and the two factors below are
// what find_outlets.h proves with.
constexpr Real kShare = Real(1) / 60, kLeast = 10;
static_assert(kLeast / kShare >= 599);
constexpr Real kOfThin = Real(1.2), kOfMoved = Real(1.1);

// Each outlet takes its time in each step: more than these are for where they will last for longer. To find them
// takes as long as some tens of steps with them.
constexpr int kFew = 2;
constexpr Real kStepsToLast = 300;
constexpr int kRounds = 6;  // each for a quarter of the motion of the one before

// Least altitude of an element, m; not above 0 if it is inverted or flat.
STICTION_LANES_INLINE Real least_altitude(const Border& border, std::size_t e,
                                          const FacePlanes& planes) {
  const auto corner = static_cast<std::size_t>(border.scene.elements[e].vertex[0]);
  const Real area2 = largest(planes.length);
  return area2 > 0 ? -planes.height(border.x[corner])[0] / area2 : Real(0);
}

// Of all edges of a vertex.
class Outward {
 public:
  Outward(const Border& border, WalkScratch& scratch, Outlets& outlets)
      : border_(border), scratch_(scratch), outlets_(outlets) {}

  // The outlets while ends and corners move by no more than `within`, m. Returns for how much of that it is
  // sure; 0 if there are more than have room.
  Real collect(Real within) {
    outlets_.count = 0;
    outlets_.may_end_in = 0;
    bool fits = true;
    const Real wide = kOfThin * border_.thin + kOfMoved * within;
    const Real never = std::numeric_limits<Real>::infinity();
    int edge = 0;
    for (const std::int32_t neighbour : border_.neighbours()) {
      const Vec3 &p = border_.at(), &q = border_.x[static_cast<std::size_t>(neighbour)];
      const EdgeWalk walk{border_.scene, border_.links, border_.x, p, q, wide, (q - p).norm()};
      in_registers(
          lane_width(), [&]() __attribute__((always_inline)) {
            walk_along(
                walk, border_.element, never, scratch_,
                [&](std::size_t e, const FacePlanes& planes) __attribute__((always_inline)) {
                  within = std::min(within, kShare * least_altitude(border_, e, planes));
                  const auto above = FacePlanes::Four(wide) * planes.length < planes.height(q);
                  if (none(above)) outlets_.may_end_in |= std::uint32_t{1} << edge;
                },
                [&](std::size_t t) { fits = add(static_cast<std::int32_t>(t), edge) && fits; });
          });
      ++edge;
    }
    return fits && within > kLeast * border_.thin ? within : Real(0);
  }

 private:
  bool add(std::int32_t triangle, int edge) {
    const auto begin = outlets_.outlet.begin(), end = begin + outlets_.count;
    const auto at = std::find_if(
        begin, end, [triangle](const auto& outlet) { return outlet.triangle == triangle; });
    if (at == outlets_.outlet.end()) return false;
    if (at == end) {
      *at = {triangle, 0};
      ++outlets_.count;
    }
    at->edges |= std::uint32_t{1} << edge;
    return true;
  }

  const Border& border_;
  WalkScratch& scratch_;
  Outlets& outlets_;
};

}  // namespace

Real find_outlets(const Border& border, Real stride, WalkScratch& scratch, Outlets& outlets) {
  const auto edges = border.neighbours();
  if (edges.size() > Outlets::kMostEdges) return 0.0;
  for (const std::int32_t v : edges) {
    const Real length = (border.x[static_cast<std::size_t>(v)] - border.at()).norm();
    if (!(length > 0.0 && std::isfinite(length))) return 0.0;
  }
  const auto own = static_cast<std::size_t>(border.element);
  Real within =
      kShare * least_altitude(border, own, planes_at(own, border.scene, border.x, scratch));
  Outlets found = outlets;
  Outward outward(border, scratch, found);
  Real best = 0.0;
  for (int round = 0; round < kRounds && within > kLeast * border.thin; ++round, within /= 4) {
    if (best > 0.0 && (outlets.count <= kFew || within <= kStepsToLast * stride)) break;
    const Real sure = outward.collect(within);
    if (!(sure > 0.0) || (best > 0.0 && found.count >= outlets.count)) continue;
    outlets = found;
    best = sure;
  }
  return best;
}

}  // namespace stiction
