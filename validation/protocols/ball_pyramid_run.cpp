// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/protocols/ball_pyramid_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "validation/observe/mean_contacts.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

namespace {

constexpr double kSunk = 0.05;                 // of r: by then it is broken
constexpr double kLookEvery = 5e-3;            // s
constexpr std::size_t kSamplesHalf = 100;      // of energies, in each half of the window
constexpr std::size_t kLooksAtContacts = 200;  // the last ones: a second

// Mean speed of contacts, weighted by normal force, m/s.
double mean_slip(const Engine& engine, bool between_balls) {
  double slip = 0.0, force = 0.0;
  for (const ContactSample& contact : engine.contacts()) {
    if (contact.against_body != between_balls) continue;
    slip += contact.normal_force * contact.slip.norm();
    force += contact.normal_force;
  }
  return force > 0.0 ? slip / force : 0.0;
}

// Δt: 0.9 of what the mesh allows, which falls with the facets and their damping.
double time_step(int frequency) {
  if (frequency <= 5) return 3.4e-4;
  return frequency == 6 ? 2.7e-4 : 2.7e-4 * std::pow(6.0 / frequency, 1.4);
}

}  // namespace

BallPyramidRun::BallPyramidRun(CaseRun& run, const BallPyramidSetup& setup,
                               const BallPyramidTimes& times)
    : run_(run), setup_(setup), times_(times) {
  setup_.drag.full_until = times_.fading;
  setup_.drag.ends = times_.settled;
  const auto settling = simulate(kSettlingFriction);
  Series kinetic{"kinetic energy while settling", "J", "time", "s", {}, {}};
  for (int k = 1; k <= 60; ++k) {
    settling->advance_to(times_.lowered * k / 60.0);
    kinetic.x.push_back(settling->time());
    kinetic.y.push_back(settling->engine().kinetic_energy());
  }
  run_.add(kinetic);
  start_ = settling->engine().save();
  shape_ = pyramid_shape(settling->engine());
  int between = 0, ground = 0;
  for (const ContactSample& contact : settling->engine().contacts()) {
    if (contact.normal_force > 0.0) (contact.against_body ? between : ground) += 1;
  }
  run_.note(
      fmt::format("settled at μ = {} in a medium: {} contacts between balls, {} on the ground; "
                  "kinetic energy {:.1e} J",
                  kSettlingFriction, between, ground, kinetic.y.back()));
}

double BallPyramidRun::top_weight() const {
  return kStandardGravity * ball_pyramid_problem(setup_).bodies[kTopBall].mass;
}

double BallPyramidRun::broken_at() const { return kSunk * setup_.radius; }

CaseRun::Running BallPyramidRun::simulate(double friction) {
  BallPyramidSetup setup = setup_;
  setup.friction = friction;
  run_.need(&Manifest::snapshots, "snapshots");
  return run_.simulate(ball_pyramid_problem(setup),
                       {.roundness = 10 * setup.frequency * setup.frequency + 2,
                        .time = time_step(setup.frequency)});
}

BallPyramidOutcome BallPyramidRun::continue_with(double friction, bool keep_series) {
  const auto simulation = simulate(friction);
  Engine& engine = simulation->engine();
  engine.restore(start_);
  simulation->record_frames(0.05);
  const std::string at = fmt::format("μ = {:.2f}", friction);
  Series height{"top ball sunk, " + at, "m", "time", "s", {}, {}};
  Series slip{"ground slip, " + at, "m/s", "time", "s", {}, {}};
  Series speed{"lower balls' speed, " + at, "m/s", "time", "s", {}, {}};
  BallPyramidOutcome outcome;
  MeanContacts contacts;
  double highest = 0.0;  // the top ball's sinking when judging begins, m
  int breaking = 0;
  const double end = times_.settled + times_.watched;
  const auto looks = static_cast<std::size_t>(std::llround((end - times_.lowered) / kLookEvery));
  const auto unjudged =
      static_cast<std::size_t>(std::llround((times_.settled - times_.lowered) / kLookEvery));
  const std::size_t judged = looks - unjudged;
  for (std::size_t k = 1; k <= looks; ++k) {
    simulation->advance_to(times_.lowered + kLookEvery * static_cast<double>(k));
    const PyramidShape shape = pyramid_shape(engine);
    outcome.sunk = shape_.top_height - shape.top_height;
    outcome.spread = shape.spread - shape_.spread;
    const double slipping = mean_slip(engine, false);
    height.x.push_back(simulation->time());
    height.y.push_back(outcome.sunk);
    slip.x.push_back(simulation->time());
    slip.y.push_back(slipping);
    speed.x.push_back(simulation->time());
    speed.y.push_back(shape.speed);
    if (k == unjudged) {
      outcome.needed_first = shape.critical_friction();
      highest = outcome.sunk;
    }
    if (k > unjudged) {
      outcome.freed = std::max(outcome.freed, top_weight() * (outcome.sunk - highest));
    }
    if (k + kLooksAtContacts > looks) contacts.add(engine.contacts());
    if (k > unjudged && (k - unjudged) % (judged / (2 * kSamplesHalf)) == 0) {
      outcome.kinetic[2 * (k - unjudged) > judged ? 1 : 0] +=
          engine.kinetic_energy() / kSamplesHalf;
    }
    if (outcome.sunk <= broken_at()) continue;
    outcome.stands = false;
    outcome.ground_slip += slipping;
    outcome.outward += shape.speed;
    ++breaking;
    if (outcome.sunk > 5.0 * broken_at()) break;
  }
  if (breaking > 0) {
    outcome.ground_slip /= breaking;
    outcome.outward /= breaking;
  }
  outcome.needed_last = pyramid_shape(engine).critical_friction();
  outcome.pair_slip = mean_slip(engine, true);
  if (outcome.stands) {
    const std::vector<ContactSample> mean = contacts.mean();
    outcome.any_loads =
        reference::critical_friction(limit_problem(engine, setup_, mean, ContactLoads::kAny));
    outcome.measured_loads =
        reference::critical_friction(limit_problem(engine, setup_, mean, ContactLoads::kMeasured),
                                     0.0, {.residual = kMovingResidual});
  }
  if (keep_series) {
    run_.add(height);
    run_.add(slip);
    run_.add(speed);
  }
  return outcome;
}

}  // namespace stiction
