// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engine/conformance/protocol_cost.h"

#include <algorithm>
#include <chrono>
#include <vector>

#include "validation/engine/conformance/probe.h"

namespace stiction {

namespace {

constexpr int kRequests = 2000;
constexpr std::uint64_t kSteps = 2000;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <class Work>
double median_seconds(const Work& work) {
  std::vector<double> seconds;
  for (int k = 0; k < kRequests; ++k) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - start;
    seconds.push_back(gone.count());
  }
  return median(std::move(seconds));
}

}  // namespace

ProtocolCost protocol_cost(const EngineKind& kind, const Settings& settings) {
  const Probe probe(kind, settings);
  Problem problem;
  problem.name = "a body on the ground";
  problem.bodies = {probe.body("body")};
  problem.bodies[0].position = Vec3(0.0, 0.0, half_height(problem.bodies[0]));
  problem.obstacles = {{"ground", Vec3::Zero(), Vec3::UnitZ(), 0.5}};
  problem.gravity = {{0.0}, {Vec3(0.0, 0.0, -9.81)}};
  const auto engine = probe.start(problem);
  ProtocolCost cost;
  cost.request = median_seconds([&] { engine->advance(0); });
  cost.request_cpu = engine->cost().cpu_seconds / kRequests;
  const double before = engine->cost().cpu_seconds;
  engine->advance(kSteps);
  cost.step_cpu = (engine->cost().cpu_seconds - before) / static_cast<double>(kSteps);
  const double stepped = median_seconds([&] { engine->advance(1); });
  const double observed = median_seconds([&] {
    engine->advance(1);
    engine->body(0);
  });
  cost.observation = observed - stepped;
  return cost;
}

}  // namespace stiction
