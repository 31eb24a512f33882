// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind `./stiction bench`: cost per contact of the one-sided contact phases and of
// the whole step, for a box at rest on a slope at 90 % of the critical one. Each batch starts from
// the same warm state, and prints its hash: equal hashes, equal work. What it cannot show: cold
// caches, contacts that come and go.
#include <benchmark/benchmark.h>

#include "reference/box_mesh.h"
#include "solver/phases/detect.h"
#include "solver/phases/friction.h"
#include "solver/phases/normal_force.h"
#include "solver/phases/predict.h"
#include "solver/step.h"

namespace stiction {

namespace {

constexpr int kWarmSteps = 20;

// A flat box of `cells` × `cells` × 1 cells on a plane: (cells + 1)² contacts.
struct Workload {
  Scene scene;
  Options options;
  State state;
  Workspace workspace;

  Workload(int cells, const char* rule) {
    const double edge = 0.01;
    BodyDescription body;
    body.name = "box";
    body.mesh = reference::box_mesh({cells * edge, cells * edge, edge}, {cells, cells, 1});
    body.mesh.vertices.row(2).array() += 0.5 * edge;
    body.material.damping_time = 1e-5;
    SceneDescription description;
    description.bodies = {body};
    description.half_spaces = {{"plane", Vec3::Zero(), Vec3::UnitZ(), 0.5}};
    description.gravity = {{0.0}, {Vec3(0.45 * 9.81, 0.0, -9.81)}};
    scene = build_scene(description);
    options.time_step = 0.5 * scene.stable_time_step;
    options.rule = rule;
    state = initial_state(scene);
    for (int k = 0; k < kWarmSteps; ++k) step(scene, options, state, workspace);
  }

  void predict_step() {
    gravity_forces(scene, 0.0, workspace.force);
    predict(options.time_step, workspace.force, state.velocity, workspace.velocity);
  }
};

void report(benchmark::State& run, const Workload& work) {
  const auto contacts = static_cast<double>(work.workspace.contacts.size());
  run.counters["contacts"] = contacts;
  run.counters["time_per_contact"] = benchmark::Counter(
      contacts, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  // 32 bits of it, which a double holds exactly.
  run.counters["hash"] = static_cast<double>(hash_of(work.state) & 0xffffffffu);
}

// Normal force and friction of all contacts, from the same predicted velocities each time.
void contact_phases(benchmark::State& run, const char* rule) {
  Workload work(static_cast<int>(run.range(0)), rule);
  work.predict_step();
  detect(work.scene, work.options.time_step, work.state.position, work.workspace.velocity,
         work.workspace.contacts);
  const std::vector<Velocity> predicted = work.workspace.velocity;
  const State start = work.state;
  for (auto _ : run) {
    run.PauseTiming();
    work.workspace.velocity = predicted;
    work.state.memory = start.memory;
    run.ResumeTiming();
    normal_forces(work.scene, work.options.time_step, work.state.position, work.workspace.velocity,
                  work.workspace.contacts);
    friction_forces(work.scene, work.options, work.state, work.workspace);
  }
  report(run, work);
}

void detection(benchmark::State& run) {
  Workload work(static_cast<int>(run.range(0)), "none");
  work.predict_step();
  for (auto _ : run) {
    detect(work.scene, work.options.time_step, work.state.position, work.workspace.velocity,
           work.workspace.contacts);
  }
  report(run, work);
}

void whole_step(benchmark::State& run, const char* rule) {
  Workload work(static_cast<int>(run.range(0)), rule);
  const State start = work.state;
  for (auto _ : run) {
    run.PauseTiming();
    work.state = start;
    run.ResumeTiming();
    step(work.scene, work.options, work.state, work.workspace);
  }
  report(run, work);
}

// Cells along an edge: 100 to 1e5 contacts, nearly.
void sizes(benchmark::internal::Benchmark* benchmark) {
  for (const int cells : {9, 31, 99, 315}) benchmark->Arg(cells);
}

BENCHMARK_CAPTURE(contact_phases, none, "none")->Apply(sizes);
BENCHMARK_CAPTURE(contact_phases, fixed_point, "fixed-point")->Apply(sizes);
BENCHMARK(detection)->Apply(sizes);
BENCHMARK_CAPTURE(whole_step, fixed_point, "fixed-point")->Apply(sizes);

}  // namespace

}  // namespace stiction

BENCHMARK_MAIN();
