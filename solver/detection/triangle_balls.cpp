// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/triangle_balls.h"

#include <algorithm>
#include <cstring>

#include "solver/lanes/in_registers.h"
#include "solver/lanes/lane_geometry.h"

namespace stiction {

namespace {

template <int Bytes>
STICTION_LANES_INLINE void bound_in_lanes(const Topology& topology, std::size_t begin,
                                          std::size_t end, const std::vector<Vec3>& x, Real margin,
                                          std::vector<TriangleBall>& ball) {
  using Number = Lanes<Bytes>;
  constexpr std::size_t kCount = Number::kCount;
  for (std::size_t first = begin; first < end; first += kCount) {
    const auto corner = [&](int k) __attribute__((always_inline)) {
      return at_vertices<Number>(x, [&](int lane) {
        return topology.triangle[std::min(first + static_cast<std::size_t>(lane), end - 1)]
            .vertex[k];
      });
    };
    const LaneVector<Number> p = corner(0), q = corner(1), r = corner(2);
    const LaneVector<Number> centre = (p + q + r) / Number(Real(3));
    const auto to = [&](const LaneVector<Number>& a) __attribute__((always_inline)) {
      const LaneVector<Number> away = a - centre;
      return dot_as_eigen(away, away);
    };
    const Number radius = sqrt(greater(to(p), greater(to(q), to(r)))) + Number(margin);
    static_assert(sizeof(TriangleBall) == sizeof(FourNumbers));
    FourNumbers balls[kCount];
    store_records(centre.x, centre.y, centre.z, radius, balls);
    void* const place = &ball[first];
    if (end - first >= kCount) {
      std::memcpy(place, balls, sizeof(balls));  // of a known size, which is a few moves
    } else {
      std::memcpy(place, balls, (end - first) * sizeof(*balls));
    }
  }
}

}  // namespace

void bound_triangles(const Topology& topology, std::size_t begin, std::size_t end,
                     const std::vector<Vec3>& x, Real margin, int width,
                     std::vector<TriangleBall>& ball) {
  in_lanes(
      static_cast<int>(end - begin), width, [&](auto bytes) __attribute__((always_inline)) {
        bound_in_lanes<bytes>(topology, begin, end, x, margin, ball);
      });
}

}  // namespace stiction
