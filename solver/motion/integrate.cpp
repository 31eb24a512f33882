// SPDX-License-Identifier: BSD-3-Clause
#include "solver/motion/integrate.h"

#include <utility>

namespace stiction {

void integrate(Real dt, std::vector<Velocity>& corrected, State& state, const Team* team) {
  std::swap(corrected, state.velocity);
  for_ranges(team, state.position.size(), kVerticesToShare,
             [&](std::size_t begin, std::size_t end) {
               for (std::size_t k = begin; k < end; ++k)
                 state.position[k].x += dt * state.velocity[k].v;
             });
}

}  // namespace stiction
