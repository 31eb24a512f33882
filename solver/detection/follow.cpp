// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/follow.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace stiction {

namespace {

// The larger of what is known and what a thread tells.
void raise(Real& most, Real here) {
  const std::atomic_ref<Real> known(most);
  Real last = known;
  while (last < here && !known.compare_exchange_weak(last, here)) {
  }
}

}  // namespace

bool follow(const Scene& scene, Real dt, const State& state, const std::vector<Velocity>& velocity,
            const Team* team, PairSearch& search) {
  // Along an axis: since the lists, and since the last x*.
  search.farthest.assign(scene.bodies.size(), 0.0);
  search.longest.assign(scene.bodies.size(), 0.0);
  const auto follow_range = [&](std::size_t begin, std::size_t end) {
    auto b = static_cast<std::size_t>(scene.topology.vertex_body[begin]);
    for (std::size_t last; begin < end; begin = last, ++b) {
      const Body& body = scene.bodies[b];
      last = std::min(end, static_cast<std::size_t>(body.first_vertex + body.vertex_count));
      Real far = 0.0, way = 0.0;
      for (std::size_t k = begin; k < last; ++k) {
        const Vec3 x = state.position[k].x + dt * velocity[k].v;
        const Vec3 by = (x - search.reference[k]).cwiseAbs();
        const Vec3 since = (x - search.predicted[k]).cwiseAbs();
        search.predicted[k] = x;
        way = std::max({way, since.x(), since.y(), since.z()});
        // Written so that what is no number counts as moved.
        if (!(by.x() <= search.skin && by.y() <= search.skin && by.z() <= search.skin)) {
          far = std::numeric_limits<Real>::infinity();
        }
        far = std::max({far, by.x(), by.y(), by.z()});
      }
      raise(search.farthest[b], far);
      raise(search.longest[b], way);
    }
  };
  for_ranges(team, state.position.size(), kVerticesToShare, follow_range);
  bool any = false;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const bool renewed = search.farthest[b] > search.skin;
    const double way = std::sqrt(3.0) * static_cast<double>(search.longest[b]);
    search.renewed[b] = renewed;
    search.moved[b] = renewed ? 0 : std::sqrt(Real(3)) * search.farthest[b];
    // Rounded up: what a body trembles adds up however far it has come.
    if (way > 0.0) search.path[b] = std::nextafter(search.path[b] + way, HUGE_VAL);
    if (renewed) search.path[b] = 0.0;
    any = any || renewed;
  }
  return any;
}

}  // namespace stiction
