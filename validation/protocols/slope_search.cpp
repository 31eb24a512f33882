// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/protocols/slope_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "validation/protocols/incline_run.h"
#include "validation/protocols/paper_figure.h"

namespace stiction {

namespace {

// A box that has come so far slides: start-up slip and shear of box and slab stay below 1.2 mm. It
// is stopped there, because further on it leaves the part of the slab that it was settled on.
constexpr double kFar = 3e-3;  // m

constexpr double kWindow = 0.4;    // s, over which a mean speed is taken
constexpr double kLongest = 20.0;  // s

// A box that no longer slows down creeps rather than slides below this speed: it would take five
// minutes for the 3 mm after which it counts as sliding.
constexpr double kCreeps = 1e-5;  // m/s

// What counts as slowing down, from window to window: a slide by 2 % (half a bracket below the
// critical slope takes g Δθ/cos θ · 0.4 s = 4e-5 m/s of the 1e-3 m/s that the ramp leaves), the
// creep of a limit cycle, which is noise, by a fifth.
constexpr double kSlideSlows = 0.98, kCreepSlows = 0.8;

// What gains more than this from window to window slides, and its acceleration tells how far the slope
// is from the critical one; of what creeps nothing does.
constexpr double kSlideGains = 0.02;

}  // namespace

Descent descend(CaseRun& run, const SlabSetup& setup, const Accuracy& accuracy) {
  SlabRun slab(run, setup, accuracy);
  const Vec3 downhill = slab_downhill(setup);
  slab.advance_to(setup.load.tangential_full);
  Descent seen{.slope = setup.slope};
  double place = slab.travel().dot(downhill), speed = INFINITY, before = INFINITY;
  int steady = 0, rested = 0;
  while (slab.time() < kLongest && place < kFar) {
    slab.advance_to(slab.time() + kWindow);
    const double now = slab.travel().dot(downhill);
    seen.creep = (now - place) / kWindow;
    place = now;
    before = std::exchange(speed, std::abs(seen.creep));
    seen.holds = speed <= kCreeps;
    steady = speed > (seen.holds ? kCreepSlows : kSlideSlows) * before ? steady + 1 : 0;
    rested += speed <= kStaticSlip;
    if (rested == 2 || steady == 3) break;
  }
  seen.holds = seen.holds && place < kFar;
  const double gain = speed - before;
  if (gain > kSlideGains * before) seen.excess = gain / kWindow;
  seen.until = slab.time();
  return seen;
}

SlopeSearch search_slope(CaseRun& run, const SlabSetup& flat, double expected, double guess,
                         double coarse, double width) {
  SlopeSearch found;
  const auto holds_at = [&](double slope) {
    SlabSetup setup = flat;
    setup.slope = radians(slope);
    found.seen.push_back(descend(run, setup));
    return Holding(found.seen.back().holds, found.seen.back().excess);
  };
  const auto creeps = [&] {
    return std::any_of(found.seen.begin(), found.seen.end(), [](const Descent& one) {
      return one.holds && std::abs(one.creep) > kStaticSlip;
    });
  };
  // d/dθ g (sin θ − μ cos θ) at the critical slope, for each degree.
  const double steeper =
      acceleration_by_slope(flat.friction) / std::pow(std::cos(std::atan(flat.friction)), 2);
  found.bracket = find_threshold_near(guess, 2.0 * coarse, 2.0, coarse, holds_at, radians(steeper));
  if (!creeps()) found.bracket = narrow(found.bracket, width, holds_at);
  std::sort(found.seen.begin(), found.seen.end(),
            [](const Descent& a, const Descent& b) { return a.slope < b.slope; });
  for (const Descent& one : found.seen) {
    if (one.holds) found.creep = std::max(found.creep, std::abs(one.creep));
  }
  run.note(
      fmt::format("E = {:.0e} Pa: holds at {:.5f}°, slides at {:.5f}°, {:+.4f}° from theory; "
                  "fastest creep of the slopes that hold {:.1e} m/s; {} runs",
                  flat.elasticity.youngs_modulus, found.bracket.holds, found.bracket.fails,
                  found.bracket.middle() - expected, found.creep, found.bracket.evaluations));
  return found;
}

SlabSetup slab_of_slopes() {
  SlabSetup flat;  // it topples only at tan θ = 2
  flat.box_size = Vec3(0.1, 0.1, 0.05);
  flat.yaw = radians(17.0);
  flat.azimuth = radians(30.0);
  flat.offset = Vec3(0.013, 0.007, 0.0);  // no vertex of the slab for 3 cm before the box
  flat.cells = 2;
  flat.slab_cells = 3;
  flat.elasticity.damping_time = 2e-3;
  // Slow, so that the box arrives at the full slope with little speed: just below the critical
  // slope what it has left takes it v²/(2 g Δθ) far.
  flat.load.tangential_full = 2.3;
  return flat;
}

}  // namespace stiction
