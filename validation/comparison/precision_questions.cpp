// SPDX-License-Identifier: GPL-3.0-or-later
// The questions of work-precision/: scenes of validation/problems/, each asked for one number.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/motion/incline.h"
#include "solver/demand.h"
#include "validation/comparison/precision_question.h"
#include "validation/problems/bar_problem.h"
#include "validation/problems/oscillator_problem.h"
#include "validation/problems/piles/stack_problem.h"
#include "validation/problems/slopes/membrane_problem.h"
#include "validation/problems/slopes/slab_problem.h"
#include "validation/protocols/incline_run.h"
#include "validation/protocols/incline_threshold.h"
#include "validation/protocols/membrane_slide.h"

namespace stiction {

namespace {

constexpr double kUlp = std::numeric_limits<double>::epsilon();
using PartOf = std::function<CaseRun(const Settings&)>;

// Half a unit in the last place of a coordinate of so many metres in each step, all to one side: the
// speed (m/s) that rounding alone may give what rests.
std::function<double(double)> rounding_of_rest(double coordinate) {
  return [coordinate](double dt) { return 0.5 * kUlp * coordinate / dt; };
}

PrecisionReference exact(double value, std::string words) {
  return {.value = value, .uncertainty = 0.0, .words = std::move(words)};
}

// Simulated with `quiet` on three refinements, at Δt and Δt/2 (s).
PrecisionReference self_converged(const PrecisionQuestion& question, const PartOf& part,
                                  const std::array<int, 3>& cells, double dt) {
  std::vector<std::array<double, 2>> answers;
  std::vector<double> h;
  for (const int one : cells) {
    const auto with = [&](double step) {
      CaseRun run = part({{"method", "quiet"}, {"dt", fmt::format("{}", step)}});
      return question.answer(run, one);
    };
    h.push_back(1.0 / one);
    answers.push_back({with(dt), with(0.5 * dt)});
  }
  PrecisionReference found = extrapolated(answers, h);
  found.words = fmt::format("Δt → 0 and h → 0 from quiet, {} cells, Δt = {} s and half of it",
                            fmt::join(cells, ", "), step_text(dt));
  return found;
}

// The cube of slope/*, on half-spaces.
InclineSetup cube() {
  InclineSetup setup;
  setup.shape = BoxShape{Vec3::Constant(0.2)};
  setup.azimuth = radians(30.0);
  return setup;
}

constexpr double kThresholdWidth = 2e-10;  // of the bracket on tan θ, to μ

PrecisionQuestion threshold() {
  InclineSetup setup = cube();
  setup.yaw = radians(20.0);
  const double mu = setup.friction;
  // Below 1e-9 m/s a box counts as resting (incline_holds): after 0.7 s of full load that is
  // g (sin θ − μ cos θ) · 0.7 s.
  const double slow = 1e-9 / (kStandardGravity * std::cos(std::atan(mu)) * 0.7);
  return {.name = "threshold",
          .title = "the slope (tan θ) at which a box begins to slide",
          .unit = "1",
          .scale = mu,
          .cells = {1, 2, 4},
          .seconds = 14.0,
          .problem = [=](int) { return settled_incline_problem(setup); },
          .answer =
              [=](CaseRun& run, int cells) {
                return incline_threshold(run, setup, kThresholdWidth * mu, {.fineness = cells})
                    .middle();
              },
          .resolution = [=](double) { return 0.5 * kThresholdWidth * mu + slow; },
          .reference = [=](const PartOf&) { return exact(mu, "tan θ = μ, exact"); }};
}

// What rests by luck in one pose may creep in another: the worst of two.
double worst_of(const std::vector<double>& answers) {
  double worst = 0.0;
  for (const double one : answers) {
    if (std::isnan(one)) return one;
    worst = std::max(worst, one);
  }
  return worst;
}

// A box in two poses on a slab of cells about as large as its own.
std::vector<SlabSetup> slabs_of(int cells) {
  std::vector<SlabSetup> poses(2, slab_at_20_degrees());
  poses[1].yaw = radians(31.0);
  poses[1].azimuth = radians(40.0);
  poses[1].offset = Vec3(-0.021, 0.017, 0.0);
  for (SlabSetup& one : poses) {
    one.cells = cells;
    one.slab_cells = cells + 1;
  }
  return poses;
}

// A question to the box in each pose.
PrecisionQuestion of_slabs(std::string name, std::string title, double seconds,
                           const std::function<double(SlabRun&)>& answer) {
  return {.name = std::move(name),
          .title = std::move(title),
          .unit = "m/s",
          .cells = {2, 3, 4},
          .seconds = 2.0 * seconds,
          .problem = [](int cells) { return slab_problem(slabs_of(cells).front()); },
          .answer =
              [answer](CaseRun& run, int cells) {
                std::vector<double> answers;
                for (const SlabSetup& setup : slabs_of(cells)) {
                  SlabRun slab(run, setup);
                  answers.push_back(answer(slab));
                }
                return worst_of(answers);
              },
          .reference = [](const PartOf&) { return exact(0.0, "at rest, exact"); }};
}

PrecisionQuestion creep() {
  constexpr double kFrom = 2.0, kTo = 4.0;  // s
  PrecisionQuestion question = of_slabs(
      "creep", "the speed at which a box at rest on a deformable slab creeps, of two poses", kTo,
      [](SlabRun& slab) {
        slab.advance_to(kFrom);
        const Vec3 before = slab.travel();
        slab.advance_to(kTo);
        return (slab.travel() - before).norm() / (kTo - kFrom);
      });
  question.lost = 0.5 * slabs_of(2).front().box_size.x() / (kTo - kFrom);
  question.resolution = rounding_of_rest(0.1);
  return question;
}

PrecisionQuestion slip() {
  constexpr double kFrom = 3.8, kTo = 4.0, kEvery = 0.01;  // s
  PrecisionQuestion question = of_slabs(
      "slip",
      "the speed of the fastest contact of a box at rest on a deformable slab, of two poses", kTo,
      [](SlabRun& slab) {
        std::vector<double> slips;
        for (double time = kFrom; time < kTo + 0.5 * kEvery; time += kEvery) {
          slab.advance_to(time);
          slips.push_back(slab.sample().fastest_slip);
        }
        return worst_of(slips);
      });
  // Some hundred roundings of velocities of g Δt.
  question.resolution = [](double dt) { return 100.0 * kUlp * kStandardGravity * dt; };
  return question;
}

PrecisionQuestion acceleration() {
  InclineSetup setup = cube();
  setup.tan_slope = 1.2 * setup.friction;
  setup.speed = 1.0;
  const double expected = reference::sliding_acceleration(
      {std::atan(setup.tan_slope), setup.friction, kStandardGravity});
  return {
      .name = "acceleration",
      .title = "the acceleration of a box that slides down",
      .unit = "m/s²",
      .scale = expected,
      .cells = {1, 2, 4},
      .seconds = 2.0,
      .problem = [=](int) { return incline_problem(setup); },
      .answer =
          [=](CaseRun& run, int cells) {
            InclineRun slide(run, setup, incline_problem(setup), {.fineness = cells});
            slide.advance_to(1.0);
            const double from = slide.time(), before = slide.speed();
            slide.advance_to(2.0);
            return (slide.speed() - before) / (slide.time() - from);
          },
      // A unit in the last place of a velocity of 2.7 m/s in each step.
      .resolution = [](double dt) { return kUlp * 2.7 / dt; },
      .reference = [=](const PartOf&) { return exact(expected, "a = g(sin θ − μ cos θ), exact"); }};
}

PrecisionQuestion stopping() {
  InclineSetup setup = cube();
  setup.speed = 2.0;
  PrecisionQuestion question{
      .name = "stopping",
      .title = "the distance in which a box thrown over level ground stops",
      .unit = "m",
      .scale = reference::stopping_distance({0.0, setup.friction, kStandardGravity}, setup.speed),
      .cells = {1, 2, 4},
      .seconds = 1.0,
      .problem = [=](int) { return incline_problem(setup); },
      .answer =
          [=](CaseRun& run, int cells) {
            InclineRun stopping(run, setup, incline_problem(setup), {.fineness = cells});
            stopping.advance_to(1.0);
            return stopping.travel();
          },
      .resolution = [](double dt) { return 0.5 * kUlp * 0.4 / dt; }};
  question.reference = [question](const PartOf& part) {
    return self_converged(question, part, {2, 4, 6}, 2e-5);
  };
  return question;
}

// Three boxes at 2° and four at 3°.
std::vector<StackSetup> stacks_of(int cells) {
  std::vector<StackSetup> stacks;
  for (const int boxes : {3, 4}) {
    StackSetup one;
    one.boxes = boxes;
    one.cells = cells;
    one.ground = Ground::kSlab;
    one.tan_slope = std::tan(radians(boxes - 1.0));
    stacks.push_back(one);
  }
  return stacks;
}

// Of the box of a resting stack that moves fastest in `window` (s).
double creep_of_stack(CaseRun& run, const StackSetup& setup, double window) {
  const auto simulation = run.simulate(stack_problem(setup));
  const auto places = [&] {
    std::vector<Vec3> all;
    for (int k = 0; k < setup.boxes; ++k) {
      all.push_back(simulation->engine().body(static_cast<std::size_t>(k)).position);
    }
    return all;
  };
  simulation->advance_to(kStackSettled);
  const std::vector<Vec3> before = places();
  simulation->advance_to(kStackSettled + window);
  const std::vector<Vec3> after = places();
  std::vector<double> speeds;
  for (std::size_t k = 0; k < before.size(); ++k) {
    speeds.push_back((after[k] - before[k]).norm() / window);
  }
  return worst_of(speeds);
}

PrecisionQuestion stack() {
  constexpr double kWindow = 2.0;  // s
  return {.name = "stack",
          .title = "the speed at which stacks of three and four boxes at rest creep",
          .unit = "m/s",
          .lost = 0.5 * stacks_of(1).front().size.x() / kWindow,
          .cells = {1, 2},
          .seconds = 2.0 * (kStackSettled + kWindow),
          .problem = [](int cells) { return stack_problem(stacks_of(cells).back()); },
          .answer =
              [](CaseRun& run, int cells) {
                std::vector<double> speeds;
                for (const StackSetup& setup : stacks_of(cells)) {
                  speeds.push_back(creep_of_stack(run, setup, kWindow));
                }
                return worst_of(speeds);
              },
          .resolution = rounding_of_rest(0.4),
          .reference = [](const PartOf&) { return exact(0.0, "v = 0, exact"); }};
}

PrecisionQuestion oscillator() {
  OscillatorSetup setup;
  setup.stretch = 5.3;
  // Five half-swings, then rest.
  const double seconds = 5.0 * std::numbers::pi / oscillator_rate(setup) + 0.5;
  PrecisionQuestion question{.name = "oscillator",
                             .title = "the stretch with which a box on a spring comes to rest",
                             .unit = "m",
                             .scale = oscillator_offset(setup),
                             .cells = {1, 2, 4},
                             .seconds = seconds,
                             .problem = [=](int) { return oscillator_problem(setup); },
                             .resolution = [](double dt) { return 0.5 * kUlp * 0.2 / dt; }};
  question.answer = [=](CaseRun& run, int cells) {
    const auto simulation = run.simulate(oscillator_problem(setup), {.fineness = cells});
    simulation->advance_to(seconds);
    return simulation->engine().body(0).position.dot(oscillator_axis(setup)) +
           setup.stretch * oscillator_offset(setup);
  };
  question.reference = [question](const PartOf& part) {
    return self_converged(question, part, {2, 4, 8}, 2e-5);
  };
  return question;
}

PrecisionQuestion membrane() {
  const auto setup = [](int cells) {
    MembraneSetup one;
    one.cells_along = cells;
    one.cells_across = std::max(1, cells / 12);
    return one;
  };
  PrecisionQuestion question{
      .name = "membrane",
      .title = "the place where a box that slides down a membrane stops",
      .unit = "m",
      .scale = 0.5 * setup(12).length,  // about the way that it slides
      .lost = 0.5,
      .cells = {12, 24, 40},
      .fineness = 3,  // as slide_down_membrane() asks for
      .seconds = membrane_problem(setup(12)).duration,
      .problem = [=](int cells) { return membrane_problem(setup(cells)); },
      .answer = [=](CaseRun& run,
                    int cells) { return slide_down_membrane(run, setup(cells)).place.back(); },
      .resolution = [](double dt) { return 0.5 * kUlp * 0.8 / dt; }};
  question.reference = [question](const PartOf& part) {
    return self_converged(question, part, {24, 40, 60}, 5e-5);
  };
  return question;
}

PrecisionQuestion bar() {
  const BarSetup setup;
  const double seconds = setup.settled + bar_turn(setup);
  PrecisionQuestion question{
      .name = "bar",
      .title = "the force that pushes a bar over a frictional bed",
      .unit = "N",
      .scale = bar_traction(setup) * setup.slip_length,
      .cells = {20, 40, 80},
      .seconds = seconds,
      .problem = [=](int) { return bar_problem(setup); },
      .answer =
          [=](CaseRun& run, int cells) {
            const auto simulation = run.simulate(bar_problem(setup), {.fineness = cells});
            simulation->advance_to(seconds);
            double force = 0.0;
            for (const ContactSample& contact : simulation->engine().contacts()) {
              force -= contact.friction_force.x();
            }
            return force;
          },
      // A unit in the last place of a velocity of U̇ in each step, times the bar's mass.
      .resolution = [=](double dt) { return kUlp * bar_push(setup) / setup.ramp / dt; }};
  question.reference = [question](const PartOf& part) {
    return self_converged(question, part, {40, 80, 110}, 5e-5);
  };
  return question;
}

}  // namespace

std::vector<PrecisionQuestion> precision_questions() {
  return {threshold(), creep(),      slip(),     acceleration(), stopping(),
          stack(),     oscillator(), membrane(), bar()};
}

}  // namespace stiction
