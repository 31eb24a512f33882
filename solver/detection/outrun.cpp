// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/outrun.h"

#include <algorithm>

#include "solver/detection/boxes.h"
#include "solver/lanes/in_registers.h"
#include "solver/lanes/packed_vec3.h"

namespace stiction {

namespace {

// The travel of each body's vertices in this step, m, as a box.
STICTION_LANES_INLINE void bound_travel(const Scene& scene, Real dt,
                                        const std::vector<Velocity>& velocity,
                                        std::vector<Box3>& travel) {
  travel.resize(scene.bodies.size());
  const Velocity* const of = velocity.data();
  for (std::size_t b = 0; b < travel.size(); ++b) {
    const auto begin = static_cast<std::size_t>(scene.bodies[b].first_vertex);
    const std::size_t end = begin + static_cast<std::size_t>(scene.bodies[b].vertex_count);
    const Box3 velocities = box_around(
        begin,
        end, [&](std::size_t v) __attribute__((always_inline)) { return PackedVec3(of[v].v); });
    travel[b] = {dt * velocities.min(), dt * velocities.max()};
  }
}

}  // namespace

void note_outrun(const Scene& scene, Real dt, const std::vector<Velocity>& velocity,
                 PairSearch& search) {
  const std::vector<Real>& width = scene.topology.least_width;
  const std::size_t count = scene.bodies.size();
  in_registers(
      lane_width(), [&]() __attribute__((always_inline)) {
        bound_travel(scene, dt, velocity, search.travel);
      });
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
