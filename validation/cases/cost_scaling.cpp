// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "reference/box_mesh.h"
#include "reference/power_law.h"
#include "validation/case_run.h"
#include "validation/incline_problem.h"

namespace stiction {

namespace {

constexpr double kCell = 0.05;  // m

MeshShape plate(int cells) {
  return {reference::box_mesh(Vec3(kCell * cells, kCell * cells, kCell), {cells, cells, 1})};
}

// A plate of n × n cells on a larger one that is held below, turned so that the two meshes nowhere
// match: (n + 1)² vertices of the upper one touch, and of the lower one those that the load presses
// into it.
Problem plates(int n) {
  const Elasticity elasticity{.youngs_modulus = 2e5, .poisson_ratio = 0.3, .damping_time = 1e-3};
  const auto body = [&](const std::string& name, int cells) {
    return ProblemBody{.name = name,
                       .shape = plate(cells),
                       .mass = 1000.0 * kCell * kCell * kCell * cells * cells,
                       .elasticity = elasticity};
  };
  ProblemBody upper = body("upper", n);
  upper.position = Vec3(0.013, 0.007, 0.5 * kCell);
  upper.rotation = Eigen::AngleAxisd(0.3, Vec3::UnitZ());
  ProblemBody lower = body("lower", static_cast<int>(std::ceil(1.3 * n)) + 1);
  lower.position = Vec3(0.0, 0.0, -0.5 * kCell);
  lower.held = HeldPart{Vec3(0.0, 0.0, -0.5 * kCell), Vec3::UnitZ()};
  Problem problem;
  problem.name = "plates";
  problem.bodies = {upper, lower};
  problem.friction = 0.5;
  problem.gravity = {{0.0}, {Vec3(0.0, 0.0, -kStandardGravity)}};
  return problem;
}

void run_scaling(CaseRun& run, const std::vector<int>& sizes) {
  if (run.engine().name != "stiction") return;  // others need not time their phases
  constexpr int kWarm = 16, kSteps = 64;        // steps; the engine times every 16th
  const std::vector<std::string> contact_phases = {"detect", "depth", "normal force", "friction"};
  std::vector<Series> each;
  for (const std::string& phase : contact_phases) {
    each.push_back({phase + " per contact", "s", "contacts", "1", {}, {}});
  }
  std::vector<double> contacts, seconds;
  for (const int n : sizes) {
    const auto simulation = run.simulate(plates(n));
    Engine& engine = simulation->engine();
    engine.advance(kWarm);
    const Cost cold = engine.cost();
    engine.advance(kSteps);
    const Cost cost = engine.cost();
    const auto seconds_of = [&](const std::string& phase) {  // a step's
      return (cost.phase_seconds.at(phase) - cold.phase_seconds.at(phase)) / kSteps;
    };
    const double per_step =
        static_cast<double>(cost.contact_updates - cold.contact_updates) / kSteps;
    double sum = 0.0;
    std::string words;
    for (std::size_t p = 0; p < contact_phases.size(); ++p) {
      const double spent = seconds_of(contact_phases[p]);
      sum += spent;
      each[p].x.push_back(per_step);
      each[p].y.push_back(spent / per_step);
      words += fmt::format(", {} {:.0f}", contact_phases[p], 1e9 * spent / per_step);
    }
    contacts.push_back(per_step);
    seconds.push_back(sum);
    run.note(fmt::format(
        "{:.0f} contacts, ns per contact: {:.0f} in all{}; elastic and other "
        "forces {:.0f}, predict {:.0f}, integrate {:.0f}",
        per_step, 1e9 * sum / per_step, words, 1e9 * seconds_of("forces") / per_step,
        1e9 * seconds_of("predict") / per_step, 1e9 * seconds_of("integrate") / per_step));
  }
  const reference::PowerLaw law = reference::fit_power_law(contacts, seconds);
  run.check({.quantity = "exponent of cost over contacts",
             .unit = "1",
             .claim = "the cost of contact grows linearly with the number of contacts",
             .formula = "time of detect, depth, normal force and friction ∝ contactsᵖ, p = 1",
             .source = "spatial hashing and one pass a phase",
             .kind = ReferenceKind::kAnalytic,
             .value = law.exponent,
             .expected = 1.0,
             .tolerance = 0.2,
             .reason = "from cache to memory a contact may cost twice as much, and twice again "
                       "while a case beside it uses the same memory: log₁₀ 4/3 = 0.2 over three "
                       "decades"});
  run.note(
      fmt::format("exponent {:.3f}, 95 % interval ± {:.3f}", law.exponent, law.exponent_margin));
  for (Series& series : each) run.add(std::move(series));
}

}  // namespace

std::vector<Case> cases_cost_scaling() {
  return {{.name = "cost/scaling",
           .title = "contact phases from 60 to 60 000 contacts",
           .variants = {{{"method", "quiet"}}},
           .run =
               [](CaseRun& run) {
                 run_scaling(run, {5, 10, 20, 42, 85, 173});
               }},
          {.name = "cost/scaling/methods",
           .title = "contact phases from 60 to 200 000 contacts, each method",
           .set = CaseSet::kFull,
           .variants = {{{"method", "paper"}}, {{"method", "quiet"}}},
           .run = [](CaseRun& run) {
             run_scaling(run, {5, 10, 20, 42, 85, 173, 316});
           }}};
}

}  // namespace stiction
