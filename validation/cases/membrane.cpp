// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/membrane.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "validation/case_run.h"
#include "validation/membrane_problem.h"
#include "validation/methods.h"

namespace stiction {

namespace {

constexpr double kFrom = 1.3;  // s: the slope is full since 1.0 s; the string model starts here
constexpr int kSamples = 175;

void run_membrane(CaseRun& run, const MembraneSetup& setup) {
  const Problem problem = membrane_problem(setup);
  Settings settings;
  if (!run.settings().contains("cells")) settings["cells"] = "3";
  const std::unique_ptr<Simulation> simulation = run.simulate(problem, settings);
  const Engine& engine = simulation->engine();
  Series kinetic{"kinetic energy of the box", "J", "time", "s", {}, {}};
  Series expected{"kinetic energy of the string model", "J", "time", "s", {}, {}};
  Series slip{"fastest contact slip", "m/s", "time", "s", {}, {}};
  Series place{"place of the box", "m", "time", "s", {}, {}};
  for (int k = 1; k <= kSamples; ++k) {
    simulation->advance_to(problem.duration * k / kSamples);
    const BodyMotion box = engine.body(1);
    double fastest = 0.0;
    for (const ContactSample& contact : engine.contacts()) {
      if (contact.against_body) fastest = std::max(fastest, contact.slip.norm());
    }
    for (Series* series : {&kinetic, &slip, &place}) series->x.push_back(simulation->time());
    kinetic.y.push_back(0.5 * setup.box_mass * box.velocity.squaredNorm());
    slip.y.push_back(fastest);
    place.y.push_back(box.position.x());
  }
  const auto from = static_cast<std::size_t>(std::lround(kFrom / problem.duration * kSamples)) - 1;
  const auto peak = static_cast<std::size_t>(
      std::max_element(kinetic.y.begin() + static_cast<std::ptrdiff_t>(from), kinetic.y.end()) -
      kinetic.y.begin());
  reference::MembraneProblem string = membrane_string(setup);
  string.length += string.tension / (setup.modulus * setup.width * setup.thickness);
  string.start = place.y[from];
  string.speed = std::sqrt(2.0 * kinetic.y[from] / setup.box_mass);
  const auto model = reference::membrane_motion(string, reference::MembraneLaw::full,
                                                problem.duration - kinetic.x[from],
                                                kSamples - 1 - static_cast<int>(from));
  double model_peak = 0.0;
  for (const reference::MembraneSample& sample : model.samples) {
    expected.x.push_back(kinetic.x[from] + sample.time);
    expected.y.push_back(sample.kinetic_energy / 1.0);
    model_peak = std::max(model_peak, sample.kinetic_energy);
  }
  run.note(
      fmt::format("peak {:.4e} at x {:.4f} t {:.3f}; model peak {:.4e}; end x {:.4f} model {:.4f} "
                  "t {:.3f}; start {:.4f} v {:.4f}; T {:.2f} end KE {:.2e}",
                  kinetic.y[peak], place.y[peak], kinetic.x[peak], model_peak, place.y.back(),
                  model.end_position, kinetic.x[from] + model.end_time, string.start, string.speed,
                  string.tension, kinetic.y.back()));
  run.add(std::move(kinetic));
  run.add(std::move(expected));
  run.add(std::move(slip));
  run.add(std::move(place));
}

}  // namespace

std::vector<Case> cases_membrane() {
  return {{.name = "paper/fig4-membrane",
           .title = "a box slides down an inclined membrane: faster, then slower",
           .set = CaseSet::kFull,
           .variants = method_variants(),
           .run = [](CaseRun& run) { run_membrane(run, MembraneSetup{}); }}};
}

}  // namespace stiction
