// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/protocols/gauntlet_rest.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

namespace {

// How far statics is from what the contacts of body 0 say, in terms of its weight.
struct Unbalanced {
  double force = 0.0;   // 1
  double moment = 0.0;  // m
  std::string force_words{}, moment_words{};
};

void compare(Unbalanced& worst, const RestOutcome& outcome, double mass) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double weight = mass * kStandardGravity;
  const Reaction reaction = reaction_on(0, outcome.contacts, outcome.motion[0].position);
  const bool broken = !outcome.broken.empty();
  const double force =
      broken ? infinity : (reaction.force - Vec3(0.0, 0.0, weight)).norm() / weight;
  const double moment = broken ? infinity : reaction.moment.norm() / weight;
  if (!(force <= worst.force)) worst.force = force, worst.force_words = outcome.words;
  if (!(moment <= worst.moment)) worst.moment = moment, worst.moment_words = outcome.words;
}

}  // namespace

Reaction reaction_on(std::size_t body, const std::vector<ContactSample>& contacts,
                     const Vec3& about) {
  Reaction sum;
  for (const ContactSample& contact : contacts) {
    const Vec3 force = contact.normal_force * contact.normal + contact.friction_force;
    const bool touches = contact.body == body;
    const bool touched = contact.against_body && contact.obstacle == body;
    if (touches == touched) continue;
    const Vec3 on_body = touches ? force : Vec3(-force);
    sum.force += on_body;
    sum.moment += (contact.position - about).cross(on_body);
  }
  return sum;
}

std::vector<RestOutcome> check_gauntlet_rest(
    CaseRun& run, const std::vector<std::pair<std::string, Problem>>& scenes,
    const GauntletRest& what) {
  run.need(&Manifest::contacts, "contacts that it tells");
  std::vector<RestOutcome> outcomes;
  Unbalanced worst;
  int gone = 0;
  std::string gone_words;
  for (const auto& [words, problem] : scenes) {
    const bool finer = outcomes.size() % 2 == 1;
    const RestScene scene{.words = words + (finer ? ", half the step" : ""),
                          .problem = problem,
                          .accuracy = {.finer = finer ? 2.0 : 1.0},
                          .settled = what.settled,
                          .window = what.window};
    for (RestOutcome& outcome : watch_rest(run, scene, kOnce, what.given_up, outcomes.empty())) {
      compare(worst, outcome, problem.bodies[0].mass);
      if (outcome.moved > what.given_up && gone++ == 0) gone_words = "first: " + outcome.words;
      outcomes.push_back(std::move(outcome));
    }
  }
  run.check({.quantity = "scenes that give way",
             .unit = "1",
             .statement = what.claim + ": it neither falls nor passes through",
             .formula = fmt::format("its centre moves by less than {:g} m", what.given_up),
             .source = what.source,
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 0.0,
             .reason = "a count"},
            gone, gone_words);
  check_rest(
      run, outcomes,
      {.drift = 1e-9 * what.window,
       .drift_reason = "the paper's 1e-9 m/s of static contacts over the window",
       .slip_reason = "vibration has decayed and the medium it settled in is gone; round-off "
                      "of velocities of g Δt = 2e-3 m/s leaves some hundred roundings of "
                      "4e-19 m/s",
       .source = what.source,
       .claim = what.claim});
  run.check({.quantity = "contact force beside the weight",
             .unit = "1",
             .statement = what.claim + ": its contacts carry its weight, and nothing else",
             .formula = "|Σ F − m g e_z| / (m g) = 0",
             .source = "static equilibrium",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 1e-8,
             .reason = "what rests at 1e-12 m/s changes its speed by no more in a step of at least "
                       "2e-5 s: 1e-7 m/s² of 9.81"},
            worst.force, worst.force_words);
  run.check({.quantity = "moment of the contact forces over the weight",
             .unit = "m",
             .statement = what.claim + ": they carry it where its centre of mass is",
             .formula = "|Σ (x − c) × F| / (m g) = 0",
             .source = "static equilibrium",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 1e-6,
             .reason = "a force and its reaction act within the standing depth of a penalty, "
                       "g Δt² n (1 − κ)/κ: 1e-6 m"},
            worst.moment, worst.moment_words);
  return outcomes;
}

}  // namespace stiction
