// SPDX-License-Identifier: GPL-3.0-or-later
// A planted fault for benchmarks/prove_track: each step moves bodies by a relative error that the
// environment variable STICTION_PLANTED_ERROR gives (dimensionless). The build renames the solver's
// own function to unplanted_integrate.
#include <cstdlib>

#include "solver/motion/integrate.h"

namespace stiction {

void unplanted_integrate(double dt, std::vector<Velocity>& corrected, State& state);

void integrate(double dt, std::vector<Velocity>& corrected, State& state) {
  static const char* const text = std::getenv("STICTION_PLANTED_ERROR");
  static const double error = text == nullptr ? 0.0 : std::atof(text);
  unplanted_integrate(dt * (1.0 + error), corrected, state);
}

}  // namespace stiction
