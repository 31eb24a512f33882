// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/protocols/clamp_threshold.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "validation/estimate/extrapolation.h"
#include "validation/protocols/clamp_limit.h"
#include "validation/protocols/paper_figure.h"

namespace stiction {

namespace {

constexpr double kStiffer = 4.0;
constexpr double kRest = 2.3e-5;  // of the criterion of rest, relative, see ClampProbe

// Stiffer material is pressed as hard by a shorter way, and rings down as fast with less β.
ClampSetup stiffer(ClampSetup setup, double factor) {
  setup.elasticity.youngs_modulus *= factor;
  setup.elasticity.damping_time /= factor;
  return setup;
}

// Its first step outwards, of the way: about as far as the guesses are off.
constexpr double kStep = 1e-3;

ClampThreshold search(CaseRun& run, const ClampSetup& setup, const ClampSearch& about, double rigid,
                      const Accuracy& accuracy = {}) {
  const ClampThreshold found = clamp_threshold(run, setup, about, accuracy);
  const ClampProbe& at = found.holds;
  run.note(
      fmt::format("E = {:.1e} Pa{}: holds at N = {:.4f} N ({:.4f} N before gravity), fails at "
                  "{:.4f} N ({:+.3f} % "
                  "of the rigid limit), {} runs. Pressure centres Δh/w = {:.5f}; of the friction "
                  "at the right jaw {:.5f} points up, "
                  "of the normal force {:.5f}",
                  setup.elasticity.youngs_modulus, accuracy.finer == 1.0 ? "" : ", half the step",
                  found.upper, at.unloaded, found.lower, 100.0 * (found.middle() / rigid - 1.0),
                  found.evaluations, at.slope, at.along, at.lift));
  return found;
}

// The way that closes the clamp to a force of `wanted` (before gravity), by the line through two
// clamps of which the second is nearly it: what is lost until all contacts bear stays out of it.
double way_for(CaseRun& run, ClampSetup setup, double way, double wanted) {
  if (std::isnan(way)) return way;
  const auto force = [&](double squeeze) {
    setup.squeeze = squeeze;
    const auto simulation = run.simulate(clamp_problem(setup));
    simulation->advance_to(kFallFrom);
    return clamp_force(simulation->engine(), setup);
  };
  const double first = force(way), near = way * wanted / first, second = force(near);
  return second == first ? near : near + (wanted - second) * (near - way) / (second - first);
}

// The same search elsewhere, begun about a clamp that is known from another; `width` is of the way.
ClampThreshold search_about(CaseRun& run, const ClampSetup& setup, double way, double width,
                            double slope, double rigid, const Accuracy& accuracy = {}) {
  if (std::isnan(way)) {
    return {.holds = {}, .fails = {}, .squeeze = way, .upper = way, .lower = way};
  }
  return search(
      run, setup,
      {.guess = way, .step = kStep * way, .reach = 0.3 * way, .width = width, .slope = slope},
      rigid, accuracy);
}

// Two brackets from the threshold: nearer to it a box takes as long as one likes to stop.
void check_rest(CaseRun& run, ClampSetup setup, const ClampThreshold& soft, double width) {
  setup.squeeze = soft.squeeze + 2.0 * width;
  ClampProbe longer;
  if (!std::isnan(soft.squeeze)) longer = probe_clamp(run, setup, {}, true);
  run.check({.quantity = "creep of the clamp that holds, after twice the time",
             .unit = "m/s",
             .statement = "a clamp that holds its box holds it at rest",
             .formula = "mean speed of the fall over 0.3 s = 0",
             .source = "Coulomb's law; [Lazarevych2009] calls 1e-9 m/s static",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = kStaticSlip,
             .reason = "the paper's own figure"},
            longer.holds ? longer.creep : std::nan(""));
}

void check_half_step(CaseRun& run, const ClampSetup& setup, const ClampThreshold& whole,
                     double width, double rigid) {
  const ClampThreshold fine =
      search_about(run, setup, whole.squeeze, width, whole.slope, rigid, {.finer = 2.0});
  run.check({.quantity = "critical clamp force at half the step ÷ at the whole one",
             .unit = "1",
             .statement = "how hard a clamp must press does not depend on the time step",
             .formula = "N(Δt/2)/N(Δt) = 1",
             .source = "Coulomb's law",
             .kind = ReferenceKind::kSelfConverged,
             .expected = 1.0,
             .tolerance = (fine.half() + whole.half()) / rigid + 2.0 * kRest,
             .reason = "half of either bracket, and 2.3e-5 of the criterion of rest each"},
            fine.middle() / whole.middle());
}

}  // namespace

void check_clamp_threshold(CaseRun& run, const ClampSetup& setup, double most, double least,
                           double width, bool half_step) {
  run.bodies_are_thrown();
  const ClampLimit limit = clamp_limit(setup);
  const double rigid = reference::in_nine_digits(0.5 * (limit.lower + limit.upper));
  const ClampSetup middle = stiffer(setup, kStiffer), hard = stiffer(middle, kStiffer);
  // Begun where a clamp of rigid bodies would need no more; then, stiffer, where the force found leads;
  // then where the trend of the two does.
  const double guess = way_for(run, setup, most, rigid);
  const ClampThreshold a = search(run, setup,
                                  {.guess = guess,
                                   .step = kStep * guess,
                                   .reach = std::max(most - guess, guess - least),
                                   .width = width},
                                  rigid);
  const double known = a.holds.unloaded;
  // What elasticity adds falls with 1/E, if it is little.
  constexpr double kLittle = 0.02;
  const bool near_rigid = std::abs(known / rigid - 1.0) < kLittle;
  const double wanted = near_rigid ? rigid + (known - rigid) / kStiffer : known;
  // A stiffer clamp's force, and with it the excess, changes by as much more with its way.
  const ClampThreshold b =
      search_about(run, middle, way_for(run, middle, a.squeeze / kStiffer, wanted),
                   width / kStiffer, kStiffer * a.slope, rigid);
  const double trend = b.holds.unloaded + (b.holds.unloaded - known) / kStiffer;
  const ClampThreshold c = search_about(run, hard, way_for(run, hard, b.squeeze / kStiffer, trend),
                                        width / (kStiffer * kStiffer), kStiffer * b.slope, rigid);
  const double coarse = extrapolate_with_order(a.middle(), b.middle(), kStiffer, 1.0);
  const double fine = extrapolate_with_order(b.middle(), c.middle(), kStiffer, 1.0);
  // An error of order 1/E² in the finer extrapolation is a fifteenth of the way that it has come.
  const double next = std::abs(fine - coarse) / (kStiffer * kStiffer - 1.0);
  // Nothing bracketed: the value is no number, and the tolerance shall be one.
  const bool found = !std::isnan(fine) && !std::isnan(coarse);
  // What one of these forces may be off by: half its bracket, the criterion, and the friction that does
  // not point up, as that at the right jaw tells.
  const auto off = [&](const ClampThreshold& of) {
    return of.half() + (kRest + 1.0 - of.holds.along) * rigid;
  };
  const double brackets = (kStiffer * off(c) + off(b)) / (kStiffer - 1.0);
  run.check(
      {.quantity = "critical clamp force, rigid limit",
       .unit = "N",
       .statement = "a clamp holds iff its friction can carry weight and couple",
       .formula = "least N with an equilibrium in the cones of all contact points",
       .source = "exact limit analysis of the rigid geometry, validation/protocols/clamp_limit.h",
       .kind = ReferenceKind::kExactComputed,
       .expected = rigid,
       .relative = true,
       .scale = rigid,
       .tolerance = found ? (brackets + next + 0.5 * (limit.upper - limit.lower)) / rigid : 0.0,
       .reason =
           "half the brackets of the searches, 2.3e-5 of the criterion of rest, and the share "
           "of friction that does not point up, as "
           "the extrapolation (4 N(16E) − N(4E))/3 weighs them; a fifteenth of its "
           "distance from that of E and 4 E, for the order 1/E²; half the analysis' "
           "bracket",
       .headline = "least force of a clamp"},
      fine);
  const Extrapolation free = extrapolate(a.middle(), b.middle(), c.middle(), kStiffer);
  run.note(
      fmt::format("limit analysis [{:.6f}, {:.6f}] N; extrapolated {:.4f} N from E and 4 E, "
                  "{:.4f} N from 4 E and 16 E; order in 1/E of all three {:.2f}, limit {:.4f}",
                  limit.lower, limit.upper, coarse, fine, free.order, free.limit));
  check_rest(run, setup, a, width);
  if (!half_step) return;
  // The claim is of rigid bodies: Fig. 3's clamp at E needs 1.4e-4 less at half the step, at 16 E no less
  // than the brackets tell. But one that turns gives at a fold, and contacts, which yield by as much as Δt²
  // allows, have the larger share in that the stiffer the bodies are (N before gravity 13.31 N at 16 E,
  // 13.13 N at half the step).
  if (near_rigid) {
    check_half_step(run, hard, c, width / (kStiffer * kStiffer), rigid);
  } else {
    check_half_step(run, setup, a, width, rigid);
  }
}

}  // namespace stiction
