// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/outrun.h"

#include <algorithm>

namespace stiction {

void note_outrun(const Scene& scene, Real dt, const std::vector<Velocity>& velocity,
                 PairSearch& search) {
  const std::vector<Real>& width = scene.topology.least_width;
  const std::size_t count = scene.bodies.size();
  // The travel of each body's vertices in this step, m, as a box.
  search.travel.assign(count, Box3());
  for (std::size_t b = 0; b < count; ++b) {
    const Body& body = scene.bodies[b];
    for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v) {
      search.travel[b].extend(Vec3(dt * velocity[static_cast<std::size_t>(v)].v));
    }
  }
  const auto farthest = [&](std::size_t b) {
    return search.travel[b].min().cwiseAbs().cwiseMax(search.travel[b].max().cwiseAbs()).norm();
  };
  for (std::size_t a = 0; a < count; ++a) {
    // No partner is slower and outrun by it.
    if (!(2 * farthest(a) > scene.topology.thinnest)) continue;
    for (std::size_t b = 0; b < count; ++b) {
      if (a == b || search.outrun.travel > 0.0) continue;
      const Vec3 ahead = search.travel[a].max() - search.travel[b].min();
      const Vec3 behind = search.travel[b].max() - search.travel[a].min();
      const Vec3 relative = ahead.cwiseMax(behind);
      Box3 swept = search.box[a];
      swept.min() -= relative;
      swept.max() += relative;
      const Real least = std::min(width[a], width[b]);
      if (relative.norm() > least && swept.intersects(search.box[b])) {
        search.outrun = {static_cast<std::int32_t>(a), static_cast<std::int32_t>(b),
                         relative.norm(), least};
      }
    }
  }
}

}  // namespace stiction
