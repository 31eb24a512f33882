// SPDX-License-Identifier: BSD-3-Clause
#include "solver/motion/integrate.h"

#include <utility>

#include "solver/lanes/packed_vec3.h"

namespace stiction {

void integrate(Real dt, std::vector<Velocity>& corrected, State& state, const Team* team) {
  std::swap(corrected, state.velocity);
  for_ranges(team, state.position.size(), kVerticesToShare,
             [&](std::size_t begin, std::size_t end) {
               in_registers(
                   lane_width(), [&]() __attribute__((always_inline)) {
                     Position* const position = state.position.data();
                     const Velocity* const velocity = state.velocity.data();
                     const Real h = dt;
                     for (std::size_t k = begin; k < end; ++k) {
                       const PackedVec3 old = PackedVec3::load(&position[k]);
                       const PackedVec3 way = h * PackedVec3::load(&velocity[k]);
                       (old + way).with_fourth(old).store(&position[k]);
                     }
                   });
             });
}

}  // namespace stiction
