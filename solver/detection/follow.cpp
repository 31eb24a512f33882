// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/follow.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "solver/lanes/packed_vec3.h"

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
      in_registers(
          lane_width(), [&]() __attribute__((always_inline)) {
            const Position* const position = state.position.data();
            const Velocity* const moves = velocity.data();
            const Vec3* const reference = search.reference.data();
            Vec3* const predicted = search.predicted.data();
            const Real h = dt;
            const PackedVec3 skin(FourNumbers{} + search.skin);
            PackedVec3 farthest = PackedVec3::Zero(), longest = PackedVec3::Zero();
            auto stays = skin.value == skin.value;
            for (std::size_t k = begin; k < last; ++k) {
              // Of the fourth number, which is anything, nothing is asked.
              const PackedVec3 x =
                  (PackedVec3::load(&position[k]) + h * PackedVec3::load(&moves[k]))
                      .without_fourth();
              const PackedVec3 by = (x - PackedVec3(reference[k])).cwiseAbs();
              const PackedVec3 since = (x - PackedVec3(predicted[k])).cwiseAbs();
              predicted[k] = vector_cast<Vec3>(x);
              longest = longest.cwiseMax(since);
              farthest = farthest.cwiseMax(by);
              // Written so that what is no number counts as moved.
              stays &= by.value <= skin.value;
            }
            way = std::max({longest.x(), longest.y(), longest.z()});
            far = std::max({farthest.x(), farthest.y(), farthest.z()});
            if (!(stays[0] && stays[1] && stays[2])) far = std::numeric_limits<Real>::infinity();
          });
      raise(search.farthest[b], far);
      raise(search.longest[b], way);
    }
  };
  for_ranges(team, state.position.size(), kVerticesToShare, follow_range);
  bool any = false;
  search.stride = 0.0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const bool renewed = search.farthest[b] > search.skin;
    const double way = std::sqrt(3.0) * static_cast<double>(search.longest[b]);
    search.renewed[b] = renewed;
    search.moved[b] = renewed ? 0 : std::sqrt(Real(3)) * search.farthest[b];
    search.stride = std::max(search.stride, way);
    // Rounded up: what a body trembles adds up however far it has come.
    if (way > 0.0) search.path[b] = std::nextafter(search.path[b] + way, HUGE_VAL);
    any = any || renewed;
  }
  if (search.stride > 0.0) {
    search.strides = std::nextafter(search.strides + search.stride, HUGE_VAL);
  }
  return any;
}

}  // namespace stiction
