// SPDX-License-Identifier: BSD-3-Clause
#include "solver/motion/integrate.h"

#include <utility>

namespace stiction {

void integrate(Real dt, std::vector<Velocity>& corrected, State& state) {
  std::swap(corrected, state.velocity);
  for (std::size_t k = 0; k < state.position.size(); ++k) {
    state.position[k].x += dt * state.velocity[k].v;
  }
}

}  // namespace stiction
