// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/workloads/workload.h"

#include <algorithm>
#include <cmath>

#include "solver/contact/slip.h"
#include "solver/observables.h"
#include "solver/step.h"
#include "validation/judge/verdict.h"

namespace stiction::bench {

namespace {

// ωT of the time under drag, after which (1 + ωT) e^{−ωT} = 1.2e-5 of the bounce is left, and of the
// free time behind it. After half of it, 7e-3 left, what the search remembers is overtaken by what still swings: a
// step of `flush` took 1.7 times as long as at rest, after half as much again 7 % less (CHANGELOG.md).
constexpr double kDragPhase = 14.0;
constexpr double kFreePhase = 0.5;

// What trembles is seen in some steps and not in others: the worst of so many is what counts.
constexpr int kWatchedSteps = 20;

bool held(const Scene& scene, const Body& body) {
  const auto first = scene.inverse_mass.begin() + body.first_vertex;
  return std::find(first, first + body.vertex_count, 0.0) != first + body.vertex_count;
}

// The largest of some figures, and whose it is; what is no number stays so.
struct Worst {
  double value = 0.0;
  std::string of;

  void add(double figure, const std::string& whose = "") {
    if (figure <= value || std::isnan(value)) return;
    value = figure;
    of = whose;
  }
};

// Each body's |Δ momentum| in one step over its weight × Δt.
void add_unbalance(const Scene& scene, const State& before, const State& after, double gravity_step,
                   Worst& worst) {
  for (const Body& body : scene.bodies) {
    if (held(scene, body)) continue;
    const double change =
        (centre_velocity(scene, after, body) - centre_velocity(scene, before, body)).norm();
    worst.add(change / gravity_step, body.name);
  }
}

// Mean tangential slip of the loaded contacts, m/s.
double mean_slip(const Scene& scene, const State& state, const Workspace& workspace) {
  double sum = 0.0;
  int loaded = 0;
  const auto add = [&](const Vec3& slip, double force) {
    if (force == 0.0) return;
    sum += slip.norm();
    ++loaded;
  };
  const auto v = [&](std::int32_t k) { return state.velocity[static_cast<std::size_t>(k)].v; };
  for (const PairContact& pair : workspace.pairs) {
    add(slip_of(pair, state.velocity), pair.normal_force);
  }
  for (const EdgeContact& edge : workspace.edges) {
    add(slip_of(edge, state.velocity), edge.normal_force);
  }
  const OneSidedContacts& contacts = workspace.contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    add(tangential(v(contacts.vertex[c]),
                   scene.half_spaces[static_cast<std::size_t>(contacts.obstacle[c])].normal),
        contacts.normal_force[c]);
  }
  return loaded > 0 ? sum / loaded : 0.0;
}

Judgement rest_check(const std::string& quantity, const std::string& statement,
                     const Worst& worst) {
  Judgement check =
      judge({.quantity = quantity,
             .unit = "1",
             .statement = statement,
             .source = "equilibrium",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 7e-3,
             .reason = "the drag leaves (1 + ωT) e^(−ωT) = 1.2e-5 of a bounce of one weight, "
                       "ωT = 14; what that is at half of its time, ωT = 7, for modes that are "
                       "slower than the family's bounce"},
            worst.value);
  check.worst = worst.of;
  return check;
}

}  // namespace

double Workload::error() const {
  Worst worst;
  for (const Judgement& check : checks) worst.add(std::abs(check.error));
  return worst.value;
}

void put_on_ground(double friction, Setup& setup) {
  setup.description.half_spaces = {{"ground", Vec3::Zero(), Vec3::UnitZ(), friction}};
  setup.description.friction = friction;
  setup.description.gravity = {{0.0}, {Vec3(0.0, 0.0, -9.81)}};
}

void go_on(Workload& work, int steps) {
  const Scene& scene = *work.scene;
  const double gravity_step = work.options.time_step * scene.gravity.at(0.0).norm();
  const int watched = std::min(kWatchedSteps, (steps + 1) / 2);
  const auto one_more = [&] { step(scene, work.options, work.state, work.workspace); };
  for (int k = watched; k < steps; ++k) one_more();
  Worst force, slip;
  for (int k = 0; k < watched; ++k) {
    const State before = work.state;
    one_more();
    add_unbalance(scene, before, work.state, gravity_step, force);
    slip.add(mean_slip(scene, work.state, work.workspace) / gravity_step);
  }
  work.checks = {
      rest_check("unbalanced force over weight", "each body is carried by its contacts", force),
      rest_check("mean slip over gΔt", "static friction holds all contacts", slip)};
}

Workload settle(const WorkloadFamily& family, int contacts) {
  Setup setup = family.make(contacts);
  const double drag_ends = kDragPhase / setup.bounce;
  setup.description.drag = {
      .rate = 2.0 * setup.bounce, .full_until = 0.9 * drag_ends, .ends = drag_ends};
  Workload work;
  work.family = family.name;
  work.size = contacts;
  work.options.rule = setup.rule;
  work.scene = std::make_shared<const Scene>(build_scene(setup.description));
  const Scene& scene = *work.scene;
  // Where nothing is elastic, any step will do.
  work.options.time_step =
      std::isfinite(scene.stable_time_step) ? 0.8 * scene.stable_time_step : 0.1 / setup.bounce;
  check_options(work.options, scene);
  work.state = initial_state(scene);
  const double seconds = (kDragPhase + kFreePhase) / setup.bounce;
  go_on(work, static_cast<int>(std::ceil(seconds / work.options.time_step)));
  return work;
}

}  // namespace stiction::bench
