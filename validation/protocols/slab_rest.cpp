// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/protocols/slab_rest.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace stiction {

SlabOutcome bring_to_rest(CaseRun& run, const SlabSetup& setup, const Settings& over,
                          SlabSeries* history) {
  constexpr double kEvery = 0.05, kLongest = 8.0;  // s
  constexpr int kPerWindow = 6;                    // samples
  constexpr int kRested = 11;                      // samples: half a second
  SlabRun slab(run, setup, {}, over);
  if (history) slab.record_frames(0.02);
  SlabOutcome outcome;
  double now = 0.0, before = INFINITY;  // highest kinetic energy in this window and the last, J
  int in_window = 0, stalled = 0, rested = 0;
  std::deque<SlabSample> late;  // those of the last half second
  for (int k = 1; kEvery * k <= kLongest; ++k) {
    slab.advance_to(kEvery * k);
    outcome.last = slab.sample();
    if (history) history->add(outcome.last);
    late.push_back(outcome.last);
    if (late.size() > kRested) late.pop_front();
    if (slab.time() <= setup.load.tangential_full) continue;
    // One sample below the bounds is no rest: it must last.
    const bool rests =
        outcome.last.fastest_slip <= kRestSlip && outcome.last.kinetic <= kRestEnergy;
    rested = rests ? rested + 1 : 0;
    outcome.at_rest = rested == kRested;
    if (outcome.at_rest) break;
    if (rests) continue;
    now = std::max(now, outcome.last.kinetic);
    if (++in_window < kPerWindow) continue;
    stalled = now > 0.5 * before ? stalled + 1 : 0;
    if (stalled == 2) break;
    before = now;
    now = 0.0;
    in_window = 0;
  }
  for (const SlabSample& sample : late) {
    outcome.fastest_slip = std::max(outcome.fastest_slip, sample.fastest_slip);
    outcome.kinetic = std::max(outcome.kinetic, sample.kinetic);
  }
  return outcome;
}

void check_slab_drift(CaseRun& run, const SlabSetup& setup) {
  constexpr double kFrom = 4.0, kTo = 14.0;  // s: by 4 s the vibration of quiet has decayed
  SlabRun slab(run, setup);
  slab.record_frames(0.1);
  SlabSeries history;
  const auto advance = [&](double from, double to, int samples) {
    for (int k = 1; k <= samples; ++k) {
      slab.advance_to(from + (to - from) * k / samples);
      history.add(slab.sample());
    }
  };
  advance(0.0, kFrom, 120);
  const Vec3 before = slab.travel();
  advance(kFrom, kTo, 50);
  const Vec3 drift = slab.travel() - before;
  history.add_to(run);
  const double tolerance = 1e-13 + 1.8e-17 * (kTo - kFrom) / slab.time_step();
  run.check({.quantity = "drift over 10 s",
             .unit = "m",
             .statement = "a box at rest on a deformable slab stays where it is",
             .formula = "x(14 s) − x(4 s) = 0",
             .source = "Coulomb's law",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = tolerance,
             .reason = "vibration left at 4 s, below 1e-13 m, and in each step 2.6 times half a "
                       "unit in the last place of a coordinate of 0.1 m, 7e-18 m"},
            drift.norm());
  run.check({.quantity = "creep",
             .unit = "m/s",
             .statement = "… its mean speed downhill over 10 s",
             .formula = "v = 0",
             .source = "Coulomb's law; [Lazarevych2009] reports 1e-9",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = tolerance / (kTo - kFrom),
             .reason = "the drift allowed, over the 10 s"},
            drift.dot(slab_downhill(setup)) / (kTo - kFrom));
}

}  // namespace stiction
