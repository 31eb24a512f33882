// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "reference/limit/limit_scenes.h"
#include "validation/core/case_run.h"
#include "validation/estimate/threshold.h"
#include "validation/problems/piles/ball_pyramid_problem.h"
#include "validation/protocols/ball_pyramid_run.h"

namespace stiction {

namespace {

constexpr double kStands = 0.24;  // the paper's two μ
constexpr double kBreaks = 0.20;

// Half-width e of the facets of frequency n over the radius: 0.087, 0.043, 0.022 at n = 4, 8, 16.
// Over so much the ground's pressure can move outwards under a lower ball, which lowers the
// critical μ by 0.82 e/r (balance of moments of a lower ball, as for four_ball_thresholds).
double facet(const BallPyramidSetup& setup) { return 0.344 / setup.frequency; }

void check_stands(CaseRun& run, const BallPyramidRun& pyramid, const BallPyramidOutcome& above) {
  const double watched = pyramid.times().watched;
  run.check({.quantity = "stands at μ = 0.24",
             .unit = "1",
             .statement = "the pyramid is stable for μ = 0.24",
             .source = "[Lazarevych2009], sec. 5, Fig. 7",
             .kind = ReferenceKind::kExternal,
             .expected = 1.0,
             .tolerance = 0.0,
             .reason = "yes or no"},
            above.stands ? 1.0 : 0.0,
            fmt::format("top ball sank {:.3f} mm until {} s after the medium was gone",
                        1e3 * above.sunk, watched));
  if (!above.stands) return;
  run.check(
      {.quantity = "friction used up in 5 s at μ = 0.24",
       .unit = "1",
       .statement = "… and goes on standing: its centres do not creep to where smooth balls break",
       .formula = "(μ_b(5 s) − μ_b(0))/(μ − μ_b(5 s)) = 0,  μ_b = tan(θ/2) from the centres",
       .source = "static equilibrium: nothing moves",
       .kind = ReferenceKind::kAnalytic,
       .expected = 0.0,
       .tolerance = 1.0,
       .reason = "at that rate what is left lasts another window of 5 s"},
      above.used(kStands),
      fmt::format("centres need μ = {:.4f} at first, {:.4f} at last; slip between "
                  "balls {:.1e} m/s at the end",
                  above.needed_first, above.needed_last, above.pair_slip));
  run.check({.quantity = "kinetic energy gained at μ = 0.24",
             .unit = "J",
             .statement = "… and gains no energy",
             .formula = "max(0, ⟨K⟩(second half) − ⟨K⟩(first half)) = 0",
             .source = "static equilibrium: nothing does work on what rests",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = above.kinetic[0] + above.freed,
             .reason = "what swings has as much energy again in its springs (virial theorem): "
                       "where swings beat, ⟨K⟩ at most doubles; and what sinking frees, m g Δh"},
            std::max(0.0, above.kinetic[1] - above.kinetic[0]),
            fmt::format("⟨K⟩ = {:.1e} J, then {:.1e} J", above.kinetic[0], above.kinetic[1]));
  run.check(
      {.quantity = "least μ of its contacts above 0.24",
       .unit = "1",
       .statement = "that it rests is possible: forces in the cones of 0.24 balance the weights, "
                    "each contact under the pressure that it has",
       .formula = "max(0, μ_LP − μ) = 0",
       .source = "limit analysis, proved in rationals, of this mesh's contacts, mean of the "
                 "last second",
       .kind = ReferenceKind::kExactComputed,
       .expected = 0.0,
       .tolerance = 0.0,
       .reason = "an exact bound, of forces that balance to 1e-3 of the weight"},
      std::max(0.0, above.measured_loads.upper - kStands),
      fmt::format("μ_LP = {:.4f} with the pressures as they are, {:.4f} with any; "
                  "smooth balls so soft {:.4f}",
                  above.measured_loads.upper, above.any_loads.upper,
                  smooth_threshold(pyramid.setup()).friction));
}

void check_breaks(CaseRun& run, const BallPyramidRun& pyramid, const BallPyramidOutcome& below) {
  run.check({.quantity = "stands at μ = 0.20",
             .unit = "1",
             .statement = "it breaks for μ = 0.20: the top ball sinks and parts the lower ones",
             .source = "[Lazarevych2009], sec. 5, Fig. 7",
             .kind = ReferenceKind::kExternal,
             .expected = 0.0,
             .tolerance = 0.0,
             .reason = "yes or no"},
            below.stands ? 1.0 : 0.0,
            fmt::format("top ball sank {:.2f} mm, lower balls moved out {:.2f} mm",
                        1e3 * below.sunk, 1e3 * below.spread));
  if (below.stands) return;
  const double patch = smooth_threshold(pyramid.setup()).ground.patch / pyramid.setup().radius;
  const double angle = patch + facet(pyramid.setup());
  run.check({.quantity = "ground slip ÷ outward speed at μ = 0.20",
             .unit = "1",
             .statement = "while it breaks the lower balls roll, they do not slide on the ground",
             .formula = "⟨u⟩/⟨v⟩ = 0",
             .source = "[Lazarevych2009], sec. 5; μ_ground = 0.1411 < 0.20",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 0.5 * angle * angle,
             .reason = "the patch, of Hertz radius a and out to the facet's edge e beyond, is flat "
                       "where the rolling ball is round: speeds across it differ by "
                       "1 − cos((a + e)/r); sliding would give 1"},
            below.ground_slip / below.outward);
}

void check_threshold(CaseRun& run, BallPyramidRun& pyramid, const BallPyramidOutcome& above,
                     const BallPyramidOutcome& below, double width) {
  BallPyramidOutcome last = above;
  const double first = above.stands ? kStands : 0.40;
  const double second = below.stands ? 0.10 : kBreaks;
  const Bracket bracket = find_threshold(first, second, width, [&](double friction) {
    if (friction == kStands) return above.stands;
    if (friction == kBreaks) return below.stands;
    const BallPyramidOutcome outcome = pyramid.continue_with(friction, false);
    if (outcome.stands) last = outcome;
    return outcome.stands;
  });
  const BallPyramidSetup& setup = pyramid.setup();
  const double smooth = smooth_threshold(setup).friction;
  run.check({.quantity = "critical μ",
             .unit = "1",
             .statement = "the pyramid breaks below the friction that smooth balls so soft need",
             .formula = "μ_b = tan(θ/2), sin θ = (2/√3)/(1 + R/r − δ/r), δ by Hertz",
             .source = "[Lazarevych2009], sec. 5: ≈ 0.22; derived in full (soft_balls.h)",
             .kind = ReferenceKind::kAnalytic,
             .expected = smooth,
             .tolerance = 0.82 * facet(setup) + 0.5 * bracket.width(),
             .reason = fmt::format("a facet of half-width e shifts it by 0.82 e/r = {:.3f}; half "
                                   "the bracket",
                                   0.82 * facet(setup))},
            bracket.middle(),
            fmt::format("stands at {:.4f}, breaks at {:.4f}", bracket.holds, bracket.fails));
  run.check({.quantity = "critical μ below the exact bound of its contacts",
             .unit = "1",
             .statement = "nothing rests with less friction than the contacts it has can do with",
             .formula = "max(0, μ_LP − μ_stands) = 0",
             .source = "limit analysis, proved in rationals, of the contact points at the end",
             .kind = ReferenceKind::kExactComputed,
             .expected = 0.0,
             .tolerance = width,
             .reason = "the bracket's width: the contacts at rest differ between its two ends"},
            std::isnan(bracket.holds) ? bracket.holds
                                      : std::max(0.0, last.any_loads.lower - bracket.holds),
            fmt::format("μ_LP = {:.5f}", last.any_loads.upper));
  run.note(fmt::format(
      "critical μ in [{:.4f}, {:.4f}]; exact limit analysis of the contacts at the lowest μ that "
      "stands: {:.4f} with the pressures as they are, {:.4f} if each may carry any load (a patch "
      "then resists rolling; elastic pressure hardly does); smooth balls: rigid {:.4f}, so soft "
      "{:.4f}, with their centres where these have them {:.4f}",
      bracket.fails, bracket.holds, last.measured_loads.upper, last.any_loads.upper,
      reference::four_ball_thresholds(setup.ratio).ball, smooth, last.needed_last));
}

void run_four_balls(CaseRun& run, int frequency, double width) {
  BallPyramidSetup setup;
  setup.frequency = frequency;
  // So soft that the patches span several facets, if n ≥ 5; stiffer balls need more.
  setup.elasticity.youngs_modulus = 3e5;
  // Balls swing between their facets at 4.5 (n = 5) to 6.5 rad/s (n = 6); twice that is critical.
  setup.drag.rate = 12.0;
  BallPyramidRun pyramid(run, setup);
  const BallPyramidOutcome above = pyramid.continue_with(kStands, true);
  const BallPyramidOutcome below = pyramid.continue_with(kBreaks, true);
  check_stands(run, pyramid, above);
  check_breaks(run, pyramid, below);
  if (width > 0.0) check_threshold(run, pyramid, above, below, width);
}

Case threshold(int frequency) {
  return {.name = fmt::format("paper/fig7-four-balls/threshold/n={}", frequency),
          .title = fmt::format("least friction of a pyramid of four balls of {} surface vertices",
                               10 * frequency * frequency + 2),
          .set = CaseSet::kFull,
          .run = [=](CaseRun& run) { run_four_balls(run, frequency, 0.005); }};
}

}  // namespace

std::vector<Case> cases_four_balls() {
  return {{.name = "paper/fig7-four-balls",
           .title = "a pyramid of four balls of 252 surface vertices stands at μ = 0.24 for 5 s, "
                    "breaks at 0.20",
           .run = [](CaseRun& run) { run_four_balls(run, 5, 0.0); }},
          threshold(4),
          threshold(5),
          threshold(6)};
}

}  // namespace stiction
