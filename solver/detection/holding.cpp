// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/holding.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/lanes/in_registers.h"
#include "solver/lanes/lane_geometry.h"

namespace stiction {

namespace {

// `point` is the point of each lane.
template <class Number>
STICTION_LANES_INLINE void least_of(const LaneVector<Number>& point, const std::vector<Vec3>& x,
                                    const std::int32_t* const* corner, int count, Real* least) {
  const auto at = [&](int k) __attribute__((always_inline)) {
    return at_vertices<Number>(x, [&](int lane) { return corner[std::min(lane, count - 1)][k]; });
  };
  const LaneWeights<Number> weight(point, at(0), at(1), at(2), at(3));
  Number smallest = weight.of[0];
  for (int k = 1; k < 4; ++k) smallest = lesser(weight.of[k], smallest);
  Real all[Number::kCount];
  store_numbers(smallest, all);
  std::copy(all, all + count, least);
}

}  // namespace

Vec4 barycentric(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ab = b - a, ac = c - a, ad = d - a, ap = point - a;
  const Vec3 ac_ad = ac.cross(ad);
  const Real volume = ab.dot(ac_ad);
  Vec4 weight;
  weight[1] = ap.dot(ac_ad) / volume;
  weight[2] = ab.dot(ap.cross(ad)) / volume;
  weight[3] = ab.dot(ac.cross(ap)) / volume;
  weight[0] = 1 - weight[1] - weight[2] - weight[3];
  return weight;
}

void least_weights(const Vec3& point, const std::vector<Vec3>& x, const std::int32_t* const* corner,
                   int count, int width, Real* least) {
  in_lanes(
      count, width, [&](auto bytes) __attribute__((always_inline)) {
        using Number = Lanes<bytes>;
        least_of<Number>({Number(point.x()), Number(point.y()), Number(point.z())}, x, corner,
                         count, least);
      });
}

void least_weights(const std::int32_t* point, const std::vector<Vec3>& x,
                   const std::int32_t* const* corner, int count, int width, Real* least) {
  in_lanes(
      count, width, [&](auto bytes) __attribute__((always_inline)) {
        using Number = Lanes<bytes>;
        const auto own =
            at_vertices<Number>(x, [&](int lane) { return point[std::min(lane, count - 1)]; });
        least_of<Number>(own, x, corner, count, least);
      });
}

Real clearance(const Vec3& point, const std::array<Vec3, 4>& corner) {
  Real most = -std::numeric_limits<Real>::infinity();
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 &a = corner[(k + 1) % 4], &b = corner[(k + 2) % 4], &c = corner[(k + 3) % 4];
    const Vec3 normal = (b - a).cross(c - a);
    const Real size = normal.norm(), inwards = normal.dot(corner[k] - a);
    if (!(size > 0.0) || inwards == 0.0) continue;
    const Real above = (inwards > 0.0 ? -1 : 1) * normal.dot(point - a) / size;
    const Real length2 = std::max({(b - a).squaredNorm(), (c - a).squaredNorm(),
                                   (corner[k] - a).squaredNorm(), (point - a).squaredNorm()});
    const Real rounding = round_off(1e-14) * std::sqrt(length2) * length2 / size;
    most = std::max(most, above + kOnBoundary * std::abs(inwards) / size - rounding);
  }
  return most;
}

Real held_within(const Vec3& point, const std::array<Vec3, 4>& corner) {
  const Real sure =
      barycentric(point, corner[0], corner[1], corner[2], corner[3]).minCoeff() - 2 * kInside;
  if (!(sure > 0.0)) return 0;
  const Vec3 ab = corner[1] - corner[0], ac = corner[2] - corner[0], ad = corner[3] - corner[0];
  const Real surface = ab.cross(ac).norm() + ac.cross(ad).norm() + ad.cross(ab).norm() +
                       (ac - ab).cross(ad - ab).norm();
  const Real radius = std::abs(ab.dot(ac.cross(ad))) / surface;
  return 2 * sure * radius / (1 + 2 * sure);
}

}  // namespace stiction
