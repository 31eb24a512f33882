// SPDX-License-Identifier: GPL-3.0-or-later
// A box pressed between two bars, as in the paper's Fig. 3, and the force that such a clamp needs.
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "validation/observe/observe.h"
#include "validation/problems/slopes/incline_problem.h"
#include "validation/protocols/clamp_threshold.h"
#include "validation/protocols/paper_figure.h"

namespace stiction {

namespace {

constexpr const char* kClampSource = "[Lazarevych2009], Fig. 3(a) and sec. 5";

// Fig. 3: coarse, narrow bars at different heights. The couple of the two offset pressures wants to
// turn the box, so that it needs the friction of both sides in full.
ClampSetup figure() {
  ClampSetup setup;
  setup.bar = Vec3(0.04, 0.14, 0.08);
  setup.bar_cells = {1, 2, 1};
  setup.offset = 0.04;
  return setup;
}

// N below which friction cannot carry weight and couple, with the pressure centres Δh apart.
double needed_force(const ClampSetup& setup, double offset) {
  return setup.box_mass * setup.fall / (2.0 * (setup.friction - offset / setup.width));
}

// What the method really lets act on the box, beside what the clamp exerts.
void note_mechanism(CaseRun& run, const ClampSetup& setup, const Engine& engine,
                    const std::string& when) {
  const JointForce left = joint_force(engine, setup, 0);
  const JointForce right = joint_force(engine, setup, setup.boxes);
  const double offset = left.height - right.height;
  const double own_offset = left.own_height - right.own_height;
  const double own = 0.5 * (left.own_normal + right.own_normal);
  run.note(fmt::format(
      "{}: the jaws' contacts carry N = {:.2f} N, pressure centres {:.1f} mm apart: rest needs "
      "{:.1f} "
      "N. Contacts of the box's own vertices alone carry {:.2f} N, {:.1f} mm apart: rest on them "
      "alone needs {:.1f} N; their friction on it adds up to {:+.2f} N left, {:+.2f} N right, of "
      "at "
      "most {:.2f} N and {:.2f} N",
      when, 0.5 * (left.normal + right.normal), 1e3 * offset, needed_force(setup, offset), own,
      1e3 * own_offset, needed_force(setup, own_offset), left.own_right.z(), right.own_left.z(),
      setup.friction * left.own_normal, setup.friction * right.own_normal));
}

// Seen from before gravity: what a reader of the figure would see.
void check_figure(CaseRun& run, const ClampSetup& setup, const Pose& from, const Pose& to) {
  run.check(
      zero_claim(kClampSource, "displacement", "m", "the clamped box doesn't slip out",
                 0.01 * setup.width,
                 "a hundredth of the box's width, about what the figure can show; the elastic "
                 "sag of box and bars under the weight is part of it"),
      to.height - from.height);
  run.check(zero_claim(kClampSource, "rotation", "°", "the clamped box doesn't turn", 1.0,
                       "about what the figure can show; elastic rotation under the weight is part "
                       "of it"),
            to.angle - from.angle);
}

void check_rest(CaseRun& run, const ClampSetup& setup, const Engine& engine, const Pose& from,
                double window) {
  const Pose to = pose_of(engine, 0);
  const double slip = kStaticSlip * window;
  run.check(zero_claim(kClampSource, "drift at rest", "m", "once settled it stays for 5 s", slip,
                       "the paper's 1e-9 m/s over the window"),
            to.height - from.height);
  run.check(zero_claim(kClampSource, "turn at rest", "°", "once settled it doesn't turn for 5 s",
                       slip / (0.5 * setup.width) * 180.0 / M_PI,
                       "the paper's 1e-9 m/s over the window, at half the width"),
            to.angle - from.angle);
  run.check(
      zero_claim(kClampSource, "kinetic energy at rest", "J", "a clamped box has none after 7 s",
                 0.5 * setup.box_mass * kStaticSlip * kStaticSlip,
                 "½ m v² of the box at the paper's 1e-9 m/s"),
      engine.kinetic_energy());
  run.check(zero_claim(kClampSource, "fastest contact slip", "m/s",
                       "static contacts end with 1e-9 m/s", kStaticSlip, "the paper's own figure"),
            fastest_slip(engine));
}

void run_figure(CaseRun& run, const ClampSetup& setup, const Accuracy& accuracy = {}) {
  constexpr double kFrom = 2.0, kWindow = 5.0;  // s
  const auto simulation = run.simulate(clamp_problem(setup), accuracy);
  simulation->record_frames(0.05);
  const Engine& engine = simulation->engine();
  ClampSeries series;
  advance_sampled(*simulation, kFallFrom, 16, series);
  const Pose unloaded = pose_of(engine, 0);
  note_mechanism(run, setup, engine, "clamped, before gravity");
  const auto out = [&] { return std::abs(pose_of(engine, 0).height) > 0.5 * setup.width; };
  const auto advance_while_in = [&](double end, int samples) {
    const double begin = simulation->time();
    for (int k = 1; k <= samples && !out(); ++k) {
      advance_sampled(*simulation, begin + (end - begin) * k / samples, 1, series);
    }
  };
  advance_while_in(kFrom, 80);
  const Pose settled = pose_of(engine, 0);
  if (!out()) note_mechanism(run, setup, engine, "under gravity, at 2 s");
  advance_while_in(kFrom + kWindow, 100);
  const Pose end = pose_of(engine, 0);
  check_figure(run, setup, unloaded, end);
  if (out()) {
    run.note(
        fmt::format("the box has slipped out: {:.0f} mm down and turned by {:.0f}° at {:.2f} s",
                    -1e3 * end.height, end.angle, simulation->time()));
  } else {
    check_rest(run, setup, engine, settled, kWindow);
  }
  series.add_to(run);
}

// Stiff bars that touch only one row of the box's vertices each: all else that carries is edges
// that cross. Two cells across, not one: only an even number of them is its own
// mirror image, as the clamp is; on one cell the box twists when it is pressed, and the friction
// across the fall that this leaves costs 1.4 % of the force at any stiffness.
ClampSetup offset_clamp() {
  ClampSetup setup;
  setup.box_cells = {2, 2, 3};
  setup.offset = setup.width / 3.0;
  setup.bar = Vec3(0.02, 0.14, 0.025);
  setup.bar_cells = {1, 1, 1};
  setup.bar_stiffness = 3.0;
  setup.friction = 0.6;
  setup.elasticity = {.youngs_modulus = 4e5, .poisson_ratio = 0.0, .damping_time = 2e-4};
  return setup;
}

}  // namespace

std::vector<Case> cases_clamped_box() {
  ClampSetup fine = figure();
  fine.box_cells = {4, 4, 4};
  fine.bar_cells = {2, 4, 2};
  ClampSetup straight;
  // A body that widens when squeezed brings friction across the fall into its contacts, and the
  // clamp has to carry that too until the box has slid far enough to turn it: 0.5 to 1 % at ν =
  // 0.3.
  straight.elasticity.poisson_ratio = 0.0;
  ClampSetup rigid = straight;
  rigid.rigid = true;
  // With a quarter of it a box that slides between half-spaces shakes itself loose at 16 E, at half and a
  // quarter of the step as well, and needs 4e-5 more force.
  rigid.elasticity.damping_time = 2e-3;
  // Bars as high and broad as the box, vertex on vertex and edge on edge.
  ClampSetup flush = straight;
  flush.flush = true;
  flush.bar = Vec3(0.04, flush.width, flush.width);
  const auto threshold = [](const ClampSetup& setup, double most, double least, double width,
                            bool half_step = false) {
    return [=](CaseRun& run) { check_clamp_threshold(run, setup, most, least, width, half_step); };
  };
  return {{.name = "paper/fig3-clamped-box",
           .title = "a box between two offset bars stays where it is",
           .run = [](CaseRun& run) { run_figure(run, figure()); }},
          {.name = "paper/fig3-clamped-box/half-step",
           .title = "a box between two offset bars stays where it is, at half the time step too",
           .run = [](CaseRun& run) { run_figure(run, figure(), {.finer = 2.0}); }},
          {.name = "paper/fig3-clamped-box/fine",
           .title = "the clamped box with half the mesh size",
           .set = CaseSet::kFull,
           .run = [fine](CaseRun& run) { run_figure(run, fine); }},
          {.name = "paper/fig3-clamped-box/threshold",
           .title = "least force of a clamp of two bars",
           .run = threshold(straight, 0.7e-3, 0.1e-3, 5e-8)},
          {.name = "paper/fig3-clamped-box/threshold/half-step",
           .title = "least force of a clamp of two bars, at half the time step too",
           .set = CaseSet::kFull,
           .run = threshold(straight, 0.7e-3, 0.1e-3, 5e-8, true)},
          {.name = "paper/fig3-clamped-box/threshold/offset",
           .title = "least force of a clamp of two bars at different heights",
           .run = threshold(offset_clamp(), 1.4e-3, 0.2e-3, 2e-7)},
          {.name = "paper/fig3-clamped-box/threshold/offset/vertices",
           .title = "… for methods without contacts of edges",
           .set = CaseSet::kFull,
           .run = threshold(offset_clamp(), 1.4e-3, 0.2e-3, 2e-7)},
          {.name = "paper/fig3-clamped-box/threshold/offset/half-step",
           .title = "least force of a clamp of two offset bars, at half the time step too",
           .set = CaseSet::kFull,
           .run = threshold(offset_clamp(), 1.4e-3, 0.2e-3, 2e-7, true)},
          {.name = "paper/fig3-clamped-box/threshold/flush",
           .title = "least force of a clamp of two bars exactly as large as the box",
           .run = threshold(flush, 0.7e-3, 0.1e-3, 1e-7)},
          {.name = "clamp/half-spaces/threshold",
           .title = "least force of a clamp of two rigid half-spaces",
           .run = threshold(rigid, 0.3e-3, 0.15e-3, 1e-8)}};
}

}  // namespace stiction
