// SPDX-License-Identifier: GPL-3.0-or-later
// A planted fault for benchmarks/prove_track: the friction phase takes 5 % longer, by the clock.
// The build renames the solver's own function to unplanted_friction_forces.
#include <chrono>

#include "solver/friction/friction.h"

namespace stiction {

void unplanted_friction_forces(const Scene& scene, const Options& options, State& state,
                               Workspace& workspace);

void friction_forces(const Scene& scene, const Options& options, State& state,
                     Workspace& workspace) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  unplanted_friction_forces(scene, options, state, workspace);
  const Clock::time_point finished = Clock::now();
  const Clock::time_point end = finished + (finished - start) / 20;
  while (Clock::now() < end) {
  }
}

}  // namespace stiction
