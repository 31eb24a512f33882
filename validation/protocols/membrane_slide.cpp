// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/protocols/membrane_slide.h"

#include <cmath>

#include "reference/motion/membrane.h"
#include "validation/protocols/membrane_reference.h"

namespace stiction {

MembraneSlide slide_down_membrane(CaseRun& run, const MembraneSetup& setup, double time) {
  constexpr int kSamples = 200;
  const Problem problem = membrane_problem(setup);
  const CaseRun::Running simulation = run.simulate(problem, {.fineness = 3, .time = time});
  simulation->record_frames(0.02);
  const Engine& engine = simulation->engine();
  MembraneSlide found;
  for (int k = 1; k <= kSamples; ++k) {
    const double before = simulation->time();
    simulation->advance_to(problem.duration * k / kSamples);
    double fastest = 0.0;
    for (const ContactSample& contact : engine.contacts()) {
      if (contact.against_body && contact.normal_force > 0.0) {
        fastest = std::max(fastest, contact.slip.norm());
      }
    }
    const BodyMotion box = engine.body(1);
    found.time.push_back(simulation->time());
    found.place.push_back(box.position.x());
    found.kinetic.push_back(0.5 * setup.box_mass * box.velocity.squaredNorm());
    found.slip.push_back(fastest);
    // From here on the string model is held beside it.
    if (before > kMembraneLoaded || simulation->time() <= kMembraneLoaded) continue;
    found.from = found.time.size() - 1;
  }
  return found;
}

double SlideCurve::mean_place() const {
  double sum = 0.0, weight = 0.0;
  for (std::size_t k = 0; k < place.size(); ++k) {
    sum += kinetic[k] * place[k];
    weight += kinetic[k];
  }
  return sum / weight;
}

BesideString beside_string(const MembraneSlide& found, const MembraneSetup& setup) {
  BesideString seen;
  const auto from = static_cast<std::ptrdiff_t>(found.from);
  seen.box = {{found.time.begin() + from, found.time.end()},
              {found.place.begin() + from, found.place.end()},
              {found.kinetic.begin() + from, found.kinetic.end()}};
  const MembraneReference model =
      membrane_reference(setup, seen.box.time.back(), seen.box.time[1] - seen.box.time[0]);
  seen.model = {model.time, model.place, model.kinetic};
  seen.length = model.length;
  const reference::MembraneProblem string = membrane_string(setup);
  seen.epsilon = 0.5 * string.own_load * model.length * std::tan(string.slope) / string.tension;
  return seen;
}

}  // namespace stiction
