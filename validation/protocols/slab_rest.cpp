// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/protocols/slab_rest.h"

#include <algorithm>
#include <cmath>

namespace stiction {

SlabOutcome bring_to_rest(CaseRun& run, const SlabSetup& setup, const Settings& over,
                          SlabSeries* history) {
  constexpr double kEvery = 0.05, kLongest = 8.0;  // s
  constexpr int kPerWindow = 6;                    // samples
  SlabRun slab(run, setup, {}, over);
  if (history) slab.record_frames(0.02);
  SlabOutcome outcome;
  double now = 0.0, before = INFINITY;  // highest kinetic energy in this window and the last, J
  int in_window = 0, stalled = 0;
  for (int k = 1; kEvery * k <= kLongest; ++k) {
    slab.advance_to(kEvery * k);
    outcome.last = slab.sample();
    if (history) history->add(outcome.last);
    if (slab.time() <= setup.load.tangential_full) continue;
    outcome.at_rest = outcome.last.fastest_slip <= kRestSlip && outcome.last.kinetic <= kRestEnergy;
    if (outcome.at_rest) break;
    now = std::max(now, outcome.last.kinetic);
    if (++in_window < kPerWindow) continue;
    stalled = now > 0.5 * before ? stalled + 1 : 0;
    if (stalled == 2) break;
    before = now;
    now = 0.0;
    in_window = 0;
  }
  return outcome;
}

}  // namespace stiction
