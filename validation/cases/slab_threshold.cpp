// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "validation/incline_run.h"
#include "validation/methods.h"
#include "validation/slab_problem.h"
#include "validation/threshold.h"

namespace stiction {

namespace {

constexpr double kWidth = 0.02;  // of the bracket on θ, degrees

double degrees(double angle) { return angle * 180.0 / std::numbers::pi; }

// A box that has come so far slides: start-up slip and shear of box and slab stay below 1 mm. It is
// stopped there, because further on it leaves the part of the slab that it was settled on.
constexpr double kFar = 3e-3;  // m

// What one slope showed: mean speeds downhill in two windows of 0.1 s, 0.3 s apart, m/s.
struct Descent {
  double slope;  // rad
  bool far = false;
  double early = 0.0;
  double late = 0.0;
};

// Mean speeds, since a limit cycle makes the speed at one moment a matter of luck.
Descent descend(CaseRun& run, const SlabSetup& setup) {
  SlabRun slab(run, setup);
  Descent seen{.slope = setup.slope};
  const auto come_to = [&](double time) {
    while (!seen.far && slab.time() < time) {
      slab.advance_to(std::min(time, slab.time() + 0.02));
      seen.far = slab.travel().dot(slab_downhill(setup)) > kFar;
    }
    return slab.travel().dot(slab_downhill(setup));
  };
  double before = come_to(1.0);
  seen.early = (come_to(1.1) - before) / 0.1;
  before = come_to(1.3);
  seen.late = (come_to(1.4) - before) / 0.1;
  return seen;
}

// Speeding up by less than half of what kWidth/2 above the critical slope would give,
// g Δθ (1 + μ tan θ) cos θ · 0.3 s, is no acceleration that the bracket could resolve.
bool holds(const Descent& seen) {
  if (seen.far) return false;
  const double resolved =
      0.5 * kStandardGravity * radians(0.5 * kWidth) / std::cos(seen.slope) * 0.3;
  return seen.late - seen.early < resolved;
}

void run_threshold(CaseRun& run, const SlabSetup& flat, double factor = 1.0) {
  std::vector<Descent> seen;
  const Bracket bracket = find_threshold(15.0, 50.0, kWidth, [&](double slope) {
    SlabSetup setup = flat;
    setup.slope = radians(slope);
    seen.push_back(descend(run, setup));
    return holds(seen.back());
  });
  const double expected = degrees(std::atan(factor * flat.friction));
  run.check({.quantity = "critical slope",
             .unit = "°",
             .claim = "a box on a deformable slab sticks if and only if tan θ ≤ μ",
             .formula = factor == 1.0 ? "θ_c = atan μ" : "θ_c = atan 2μ: the trap",
             .source = "Coulomb's law; [Lazarevych2009], sec. 5",
             .kind = ReferenceKind::kAnalytic,
             .value = bracket.middle(),
             .expected = expected,
             .tolerance = 0.05,
             .reason = "half the bracket, 0.01°; contacts at the slab's dents are tilted by up to "
                       "depth over cell, 1e-4 / 0.05 = 0.1°, either way, and their mean by less "
                       "than half of that"});
  std::sort(seen.begin(), seen.end(),
            [](const Descent& a, const Descent& b) { return a.slope < b.slope; });
  Series creep{"mean speed downhill at 1.35 s", "m/s", "slope", "°", {}, {}};
  double fastest_held = 0.0;
  for (const Descent& one : seen) {
    if (one.far) continue;
    creep.x.push_back(degrees(one.slope));
    creep.y.push_back(one.late);
    if (holds(one)) fastest_held = std::max(fastest_held, one.late);
  }
  run.add(std::move(creep));
  run.note(
      fmt::format("holds at {:.4g}°, slides at {:.4g}°: {:+.3f}° from theory; fastest mean "
                  "creep of the slopes that hold {:.1e} m/s; {} runs",
                  bracket.holds, bracket.fails, bracket.middle() - expected, fastest_held,
                  bracket.evaluations));
}

}  // namespace

std::vector<Case> cases_slab_threshold() {
  SlabSetup flat;  // it topples only at tan θ = 2
  flat.box_size = Vec3(0.1, 0.1, 0.05);
  flat.yaw = radians(17.0);
  flat.azimuth = radians(30.0);
  flat.offset = Vec3(0.013, 0.007, 0.0);  // no vertex of the slab for 3 cm before the box
  flat.cells = 2;
  flat.slab_cells = 3;
  flat.elasticity.damping_time = 2e-3;
  std::vector<Settings> variants = method_variants();
  variants.push_back({{"method", "paper"}, {"memory", "keep"}});
  SlabSetup turned = flat;
  turned.azimuth = radians(75.0);
  turned.offset = Vec3(0.02, 0.01, 0.0);
  turned.cells = 3;
  turned.slab_cells = 4;
  return {{.name = "slab/threshold",
           .title = "critical slope of a box on a deformable slab",
           .variants = variants,
           .run = [flat](CaseRun& run) { run_threshold(run, flat); }},
          {.name = "slab/threshold/fine",
           .title = "… on another mesh, falling another way",
           .set = CaseSet::kFull,
           .variants = variants,
           .run = [turned](CaseRun& run) { run_threshold(run, turned); }},
          {.name = "slab/threshold/bound=literal",
           .title = "the 2μ trap: μ times the force before it is halved",
           .variants = {{{"method", "paper"}, {"bound", "literal"}}},
           .run = [flat](CaseRun& run) { run_threshold(run, flat, 2.0); }}};
}

}  // namespace stiction
