// SPDX-License-Identifier: GPL-3.0-or-later
// A box on the slab in poses that a person tries first, and with little damping.
#include <fmt/format.h>

#include <vector>

#include "validation/observe/rest_watch.h"
#include "validation/problems/slopes/slab_poses.h"
#include "validation/problems/slopes/slab_problem.h"
#include "validation/protocols/slab_rest.h"

namespace stiction {

namespace {

RestBounds bounds(const std::string& claim, double window) {
  return {.drift = 1e-9 * window,
          .drift_reason = "the paper's 1e-9 m/s of static contacts over the window",
          .slip = kRestSlip,
          .slip_reason =
              "vibration has decayed by then; round-off of velocities of g Δt = 2e-3 m/s "
              "leaves some hundred roundings of 4e-19 m/s",
          .claim = claim};
}

// Gone before rest is judged. `drag`: its rate (1/s), until when it is full and when it has ended.
constexpr Drag kMedium{.rate = 30.0, .full_until = 3.0, .ends = 4.0};

void run_poses(CaseRun& run, int count, std::uint32_t seed, const Asked& asked) {
  // s: the slowest vibration left (a box with its corner on the slab's) loses a decade of its speed
  // in 0.6 s.
  constexpr double kSettled = 5.0, kWindow = 2.0;
  std::vector<RestOutcome> outcomes;
  std::vector<int> resting(kPoses), all(kPoses);
  for (const PosedSlab& posed : posed_slabs(count, seed)) {
    RestScene scene{.words = pose_words(posed),
                    .problem = slab_problem(posed.setup),
                    .accuracy = {.fineness = posed.setup.cells},
                    .settled = kSettled,
                    .window = kWindow};
    // A box over an edge rocks at some 20 rad/s, which β would take 10 s to end: the medium of the
    // cases of little damping below does it in three.
    if (posed.pose == SlabPose::kHanging) scene.problem.drag = kMedium;
    for (RestOutcome& outcome : watch_rest(run, scene, asked, 0.05, outcomes.empty())) {
      const auto kind = static_cast<std::size_t>(posed.pose);
      ++all[kind];
      resting[kind] += outcome.drift <= 1e-9 * kWindow && outcome.fastest_slip <= kRestSlip;
      outcomes.push_back(std::move(outcome));
    }
  }
  run.note(
      fmt::format("at rest: anywhere {} of {}, flush {} of {}, corner on corner {} of {}, "
                  "covering {} of {}, hanging {} of {}",
                  resting[0], all[0], resting[1], all[1], resting[2], all[2], resting[3], all[3],
                  resting[4], all[4]));
  check_rest(run, outcomes, bounds("a box rests in any pose on a deformable slab", kWindow));
}

void run_damping(CaseRun& run, double damping_time, const Asked& asked) {
  constexpr double kSettled = 5.0, kWindow = 4.0;  // s
  std::vector<RestOutcome> outcomes;
  std::vector<SlabSetup> setups = {slab_at_20_degrees(), fixed_slabs()[0], fixed_slabs()[5]};
  for (SlabSetup& setup : setups) {
    setup.elasticity.damping_time = damping_time;
    RestScene scene{.words = slab_words(setup),
                    .problem = slab_problem(setup),
                    .accuracy = {.fineness = setup.cells},
                    .settled = kSettled,
                    .window = kWindow};
    // Without it the first bounce alone would take a minute to decay by nine decades. It is gone
    // before rest is judged.
    scene.problem.drag = kMedium;
    for (RestOutcome& outcome : watch_rest(run, scene, asked, 0.05, outcomes.empty())) {
      outcomes.push_back(std::move(outcome));
    }
  }
  check_rest(run, outcomes, bounds("a box rests on a slab, however little both damp", kWindow));
}

Case damping(double damping_time, CaseSet set, const Asked& asked) {
  return {.name = fmt::format("slab/rest/damping/beta={:.0e}{}", damping_time,
                              asked.half_the_step ? "/doubled" : ""),
          .title = fmt::format("three poses rest on a deformable slab with β = {:.0e} s{}",
                               damping_time, asked.half_the_step ? ", asked thrice" : ""),
          .set = set,
          .run = [=](CaseRun& run) { run_damping(run, damping_time, asked); }};
}

}  // namespace

std::vector<Case> cases_slab_rest_hard() {
  std::vector<Case> cases = {
      {.name = "slab/rest/many/20",
       .title = "twenty random poses, flush, corner and hanging ones among them, rest",
       .run = [](CaseRun& run) { run_poses(run, 20, 7, kOnce); }},
      {.name = "slab/rest/many/200",
       .title = "two hundred random poses, flush, corner and hanging ones among them, rest",
       .set = CaseSet::kFull,
       .run = [](CaseRun& run) { run_poses(run, 200, 8, kOnce); }},
      {.name = "slab/rest/many/200/again",
       .title = "two hundred other random poses, flush, corner and hanging ones among them, rest",
       .set = CaseSet::kFull,
       .run = [](CaseRun& run) { run_poses(run, 200, 9, kOnce); }},
      {.name = "slab/rest/many/20/doubled",
       .title = "twenty random poses rest, in twice the window, with half the step",
       .set = CaseSet::kFull,
       .run = [](CaseRun& run) { run_poses(run, 20, 7, kDoubled); }}};
  for (const double beta : {1e-5, 1e-4, 1e-3}) {
    cases.push_back(damping(beta, CaseSet::kDefault, kOnce));
    cases.push_back(damping(beta, CaseSet::kFull, kDoubled));
  }
  return cases;
}

}  // namespace stiction
