// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/clamp_threshold.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "validation/methods.h"

namespace stiction {

namespace {

constexpr double kStiffer = 4.0;

struct Measured {
  double ratio = 0.0;         // of the critical force to the formula's
  double half_bracket = 0.0;  // of the ratio
};

Measured measure(CaseRun& run, ClampSetup setup, double factor, double most, double least,
                 double width) {
  // Stiffer material is pressed as hard by a shorter way, and rings down as fast with less β.
  setup.elasticity.youngs_modulus *= factor;
  setup.elasticity.damping_time /= factor;
  const ClampThreshold found =
      clamp_threshold(run, setup, most / factor, least / factor, width / factor);
  const ClampProbe& at = found.holds;
  const double friction = setup.friction * at.along - at.slope + at.lift;
  const double rigid = setup.boxes * setup.box_mass * setup.fall / (2.0 * friction);
  const double middle = 0.5 * (found.lower + found.upper);
  run.note(fmt::format(
      "E = {:.0e} Pa: holds at N = {:.4f} N, fails at {:.4f} N, {} runs; formula {:.4f} N "
      "({:+.3f} %) with a = {:.5f}, Δh/w = {:.5f}, t = {:.5f}",
      setup.elasticity.youngs_modulus, found.upper, found.lower, found.evaluations, rigid,
      100.0 * (middle / rigid - 1.0), at.along, at.slope, at.lift));
  return {middle / rigid, 0.5 * (found.upper - found.lower) / rigid};
}

}  // namespace

void check_clamp_threshold(CaseRun& run, const ClampSetup& setup, double most, double least,
                           double width) {
  const Measured soft = measure(run, setup, 1.0, most, least, width);
  const Measured stiff = measure(run, setup, kStiffer, most, least, width);
  const auto to_rigid = [](double at_stiff, double at_soft) {
    return (kStiffer * at_stiff + at_soft) / (kStiffer - 1.0);
  };
  constexpr double kRest = 8e-5;  // of the criterion of rest, see ClampProbe
  const double ratio = to_rigid(stiff.ratio, -soft.ratio);
  run.check({.quantity = "critical clamp force ÷ balance, rigid limit",
             .unit = "1",
             .claim = "a clamp holds iff its friction can carry the weight",
             .formula = "N = n m g/(2(aμ − Δh/w + t))",
             .source = "balance of force and couple with Coulomb's law at both jaws",
             .kind = ReferenceKind::kAnalytic,
             .value = ratio,
             .expected = 1.0,
             .tolerance = to_rigid(stiff.half_bracket + kRest, soft.half_bracket + kRest),
             .reason = "half the brackets left by the bisections and 8e-5 of the criterion of "
                       "rest, each as the extrapolation (4 x(4E) − x(E))/3 weighs it"});
}

}  // namespace stiction
