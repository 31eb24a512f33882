// SPDX-License-Identifier: GPL-3.0-or-later
// A bar across a bar: edges over edges, and no vertex in a body.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "validation/observe/rest_watch.h"
#include "validation/problems/piles/crossed_bars_problem.h"

namespace stiction {

namespace {

void run_bars(CaseRun& run, const std::vector<CrossedBarsSetup>& setups, const Asked& asked,
              double window) {
  std::vector<RestOutcome> outcomes;
  std::string fallen_words;
  int fallen = 0;
  for (const CrossedBarsSetup& setup : setups) {
    const double thickness = setup.size.z();
    const RestScene scene{.words = crossed_bars_words(setup),
                          .problem = crossed_bars_problem(setup),
                          .settled = 4.0,
                          .window = window};
    const auto all = watch_rest(run, scene, asked, 0.5 * thickness, outcomes.empty());
    const auto fell = std::find_if(all.begin(), all.end(), [&](const RestOutcome& outcome) {
      return outcome.moved > 0.5 * thickness || !outcome.broken.empty();
    });
    if (fell != all.end() && fallen++ == 0) fallen_words = "first: " + fell->words;
    outcomes.insert(outcomes.end(), all.begin(), all.end());
  }
  run.check({.quantity = "placements that fall through",
             .unit = "1",
             .statement = "a bar laid across another stays on it",
             .formula = "centre moved by less than half the thickness",
             .source = "its centre of mass lies over the crossing",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 0.0,
             .reason = "a count: bodies do not pass through each other"},
            static_cast<double>(fallen), fallen_words);
  check_rest(
      run, outcomes,
      {.drift = 1e-9 * window,
       .drift_reason = "the paper's 1e-9 m/s of static contacts over the window",
       .slip_reason = "vibration has decayed and the medium it settled in is gone; round-off "
                      "of velocities of g Δt = 2e-3 m/s leaves some hundred roundings of "
                      "4e-19 m/s",
       .source = "static equilibrium: its centre of mass lies over the crossing",
       .claim = "crossed bars rest"});
}

}  // namespace

std::vector<Case> cases_bars_crossed() {
  const auto bars = [](const Asked& asked, double window) {
    return [=](CaseRun& run) { run_bars(run, crossed_bars(), asked, window); };
  };
  return {{.name = "bars/crossed",
           .title = "a bar laid across another in sixteen ways stays on it",
           .run = bars(kOnce, 2.0)},
          {.name = "bars/crossed/doubled",
           .title = "sixteen crossed bars, in twice the window, with half the step",
           .set = CaseSet::kFull,
           .run = bars(kDoubled, 5.0)}};
}

}  // namespace stiction
