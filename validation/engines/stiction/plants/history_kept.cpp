// SPDX-License-Identifier: GPL-3.0-or-later
// A planted fault: each step leaves a number behind that nobody gives back.
#include "solver/motion/integrate.h"

namespace stiction {

void unplanted_integrate(double dt, std::vector<Velocity>& corrected, State& state,
                         const Team* team);

void integrate(double dt, std::vector<Velocity>& corrected, State& state, const Team* team) {
  thread_local std::vector<double> kept;
  unplanted_integrate(dt, corrected, state, team);
  kept.push_back(dt);
}

}  // namespace stiction
