// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/motion/incline_ode.h"
#include "validation/estimate/extrapolation.h"
#include "validation/protocols/incline_run.h"

namespace stiction {

namespace {

// The slope's load rises above the critical one and falls back: stick, slip, stick.
Problem push_and_release(const InclineSetup& setup) {
  Problem problem = settled_incline_problem(setup);
  const InclineFrame frame = incline_frame(setup);
  const Vec3 rest = problem.gravity.acceleration.back();
  const Vec3 push = rest + 0.5 * kStandardGravity * frame.downhill;
  problem.gravity.time.insert(problem.gravity.time.end(), {1.0, 1.1, 1.2, 1.3});
  problem.gravity.acceleration.insert(problem.gravity.acceleration.end(), {rest, push, push, rest});
  return problem;
}

// The same load history on a point mass, by an independent integrator with stick and slip events.
reference::FrictionalMotion reference_motion(const InclineSetup& setup, const Problem& problem) {
  const InclineFrame frame = incline_frame(setup);
  reference::FrictionalLoads loads;
  loads.friction = setup.friction;
  loads.breakpoints = problem.gravity.time;
  loads.tangential = [=](double t, double, double) {
    return frame.downhill.dot(problem.gravity.at(t));
  };
  loads.normal = [=](double t, double, double) { return -frame.normal.dot(problem.gravity.at(t)); };
  return reference::integrate_frictional_motion(loads, {}, 2.0, {.sample_interval = 0.01});
}

// With the damping ratio kept.
InclineSetup with_stiffness(InclineSetup setup, double factor) {
  setup.elasticity.youngs_modulus *= factor;
  setup.elasticity.damping_time /= std::sqrt(factor);
  return setup;
}

double travel_of_push(CaseRun& run, const InclineSetup& setup) {
  InclineRun incline(run, setup, push_and_release(setup));
  incline.advance_to(1.0);
  const double before = incline.travel();
  incline.advance_to(2.0);
  return incline.travel() - before;
}

Claim travel_claim(double expected, double tolerance, const std::string& reason) {
  return {.quantity = "travel of the push, rigid limit",
          .unit = "m",
          .statement = "it slides as far as Coulomb's law says for this load history",
          .formula = "v̇ = g_t(t) − μ gₙ(t) while it slides; stick when |g_t| ≤ μ gₙ at v = 0",
          .source = "GSL odeiv2 with stick and slip events, reference/motion/incline_ode.h",
          .kind = ReferenceKind::kExactComputed,
          .expected = expected,
          .tolerance = tolerance,
          .reason = reason};
}

// An elastic box breaks away while it still leans, and so travels further than a rigid one. If that
// is the time a shear wave needs, it falls with √E; if it is the lean itself, with E. Which of them
// is not assumed: the order comes from E, 4 E and 16 E, and a fourth stiffness, 64 E, is predicted
// from the three.
//
// `truncation`: symplectic Euler reads a load at the start of its step, half a step late on the way
// up and on the way down again: what remains is the travel of a step, m.
void check_travel(CaseRun& run, const InclineSetup& setup, double travel, double rigid,
                  double truncation) {
  const std::string of_step = "truncation: the travel of one step at full speed";
  if (std::holds_alternative<PointShape>(setup.shape)) {
    run.check(travel_claim(rigid, truncation, of_step), travel);
    return;
  }
  constexpr double kRatio = 4.0;
  std::vector<double> travels{travel};
  for (const double factor : {kRatio, kRatio * kRatio, kRatio * kRatio * kRatio}) {
    travels.push_back(travel_of_push(run, with_stiffness(setup, factor)));
  }
  const Extrapolation soft = extrapolate(travels[0], travels[1], travels[2], kRatio);
  const Extrapolation stiff = extrapolate(travels[1], travels[2], travels[3], kRatio);
  run.check(travel_claim(rigid, truncation + std::abs(stiff.limit - soft.limit),
                         of_step + ", and what the limit moves when E is left out of four "
                                   "stiffnesses"),
            stiff.limit);
  const double predicted = soft.limit + (travels[2] - soft.limit) * std::pow(kRatio, -soft.order);
  run.check({.quantity = "travel at 64 E, predicted from E, 4 E and 16 E",
             .unit = "m",
             .statement = "what elasticity adds falls with one power of the stiffness",
             .formula = "d(64E) = d₀ + a (64E)^−p, p fitted",
             .source = "the softer boxes",
             .kind = ReferenceKind::kSelfConverged,
             .expected = predicted,
             .tolerance = 4e-5,
             .reason = "what another power may add at E: the lengths by which the box leans and is "
                       "pressed together, 4e-5 m, as where it stops from sliding"},
            travels[3]);
  run.note(fmt::format(
      "an elastic box travels further than the rigid one, by {:.2e}, {:.2e}, {:.2e}, {:.2e} m at "
      "E, 4 E, 16 E, 64 E: that falls with E to the power of {:.2f} (from the softer three), "
      "{:.2f} "
      "(from the stiffer three); a shear wave's time would give 0.5, the lean 1",
      travels[0] - rigid, travels[1] - rigid, travels[2] - rigid, travels[3] - rigid, soft.order,
      stiff.order));
}

void run_restick(CaseRun& run, const InclineSetup& setup) {
  const Problem problem = push_and_release(setup);
  InclineRun incline(run, setup, problem);
  incline.record_frames(0.02);
  InclineSeries series;
  advance_sampled(incline, 1.0, 50, series);
  const double before = incline.travel();
  advance_sampled(incline, 1.3, 60, series);
  // It slides on after the push has ended, and stops within v/a: at most 0.2 s for the 0.5 m/s it
  // has.
  advance_sampled(incline, 2.0, 100, series);
  const double stopped = incline.travel();
  double furthest = stopped;
  double back = 0.0;
  for (int k = 1; k <= 200; ++k) {
    incline.advance_to(2.0 + 0.01 * k);
    series.sample(incline);
    furthest = std::max(furthest, incline.travel());
    back = std::max(back, furthest - incline.travel());
  }
  series.add_to(run);

  const double steps = 2.0 / incline.time_step();
  const double round_off = steps * 0.5 * std::numeric_limits<double>::epsilon() * 0.1;
  run.check({.quantity = "spring-back",
             .unit = "m",
             .statement = "a box pushed into sliding and released stays where it stopped",
             .formula = "max x − x = 0",
             .source = "Coulomb's law: friction only resists",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = round_off,
             .reason = "round-off: half a unit in the last place of a coordinate, every step"},
            back);
  run.check({.quantity = "creep after the push",
             .unit = "m/s",
             .statement = "friction memory of the first rest does not disturb the second",
             .formula = "v = 0",
             .source = "Coulomb's law",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = round_off / 2.0,
             .reason = "round-off as above, over 2 s"},
            (incline.travel() - stopped) / 2.0);
  run.check({.quantity = "energy at rest",
             .unit = "J",
             .statement = "it comes to rest",
             .formula = "½Σmv² = 0",
             .source = "Coulomb's law",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 1e-24,
             .reason = "the goal of the deformable cases: 1.4e-12 m/s for 1 kg"},
            incline.engine().kinetic_energy());
  const reference::FrictionalMotion motion = reference_motion(setup, problem);
  double fastest = 0.0;
  for (const auto& sample : motion.samples) fastest = std::max(fastest, sample.velocity);
  check_travel(run, setup, stopped - before, motion.samples.back().position,
               fastest * incline.time_step());
}

}  // namespace

std::vector<Case> cases_incline_restick() {
  const auto restick = [](const std::string& name, const Shape& shape, CaseSet set) -> Case {
    InclineSetup setup;
    setup.azimuth = radians(30.0);
    setup.tan_slope = 0.3;
    setup.shape = shape;
    // The travels of four stiffnesses are extrapolated to the rigid body's.
    setup.must_deform = !std::holds_alternative<PointShape>(shape);
    return {
        .name = "incline/restick/" + name,
        .title = "stick, slip, stick: a load above the critical one comes and goes (" + name + ")",
        .set = set,
        .run = [setup](CaseRun& run) { run_restick(run, setup); }};
  };
  return {restick("box", InclineSetup{}.shape, CaseSet::kQuick),
          restick("point", PointShape{}, CaseSet::kDefault)};
}

}  // namespace stiction
