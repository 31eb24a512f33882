// SPDX-License-Identifier: GPL-3.0-or-later
// What is hard for a rule that remembers: loads that turn, contacts that change or go, a load near
// the cone, depths that are wrong. All on the box on a slab.
#include <cmath>
#include <numbers>

#include "validation/comparison/comparison.h"
#include "validation/comparison/rule_history.h"
#include "validation/protocols/incline_run.h"

namespace stiction {

namespace {

constexpr double kSettled = 2.0;               // s
constexpr double kBegins = 2.1;                // 500 steps after the memory was lost, s
constexpr double kTimeStep = 2e-4;             // s
constexpr std::uint64_t kStepsOfSlide = 3000;  // to 2.6 s

// The load at slope θ and azimuth φ, m/s².
Vec3 load(double slope, double azimuth) {
  return kStandardGravity * (std::sin(slope) * Vec3(std::cos(azimuth), std::sin(azimuth), 0.0) -
                             std::cos(slope) * Vec3::UnitZ());
}

ComparisonScene hard(const std::string& name, const std::string& title, const SlabSetup& setup) {
  return {.name = name,
          .title = title,
          .problem = slab_problem(setup),
          .settings = {{"cells", std::to_string(setup.cells)}, {"dt", "2e-4"}},
          .settled = kSettled,
          .steps = kStepsOfSlide,
          .size = setup.box_size.x()};
}

void then(ComparisonScene& scene, double time, const Vec3& gravity) {
  scene.problem.gravity.time.push_back(time);
  scene.problem.gravity.acceleration.push_back(gravity);
}

ComparisonScene perpendicular() {
  const SlabSetup setup = comparison_slab();
  ComparisonScene scene = hard("perpendicular", "the load jumps by 90° within a step", setup);
  then(scene, kBegins, load(setup.slope, 0.0));
  then(scene, kBegins + kTimeStep, load(setup.slope, 0.5 * std::numbers::pi));
  return scene;
}

ComparisonScene rotating() {
  constexpr int kTurns = 2, kKnots = 32;
  constexpr double kPeriod = 0.2;  // s
  const SlabSetup setup = comparison_slab();
  ComparisonScene scene = hard("rotating", "the load's direction turns twice in 0.4 s", setup);
  for (int k = 0; k <= kTurns * kKnots; ++k) {
    const double turns = static_cast<double>(k) / kKnots;
    then(scene, kBegins + turns * kPeriod, load(setup.slope, 2.0 * std::numbers::pi * turns));
  }
  return scene;
}

// Aligned and centred: every vertex of the box lies on an edge of the slab's mesh, as near to the
// triangle on one side as to that on the other.
ComparisonScene switching() {
  SlabSetup setup = comparison_slab();
  setup.yaw = 0.0;
  setup.offset = Vec3::Zero();
  ComparisonScene scene =
      hard("switching-triangles",
           "each vertex on an edge between triangles, under a load to and fro", setup);
  for (int k = 0; k < 50; ++k) {
    then(scene, kBegins + 0.01 * k, load(setup.slope, k % 2 == 0 ? 0.0 : radians(20.0)));
  }
  return scene;
}

// Every contact lets go each time, and finds its load again.
ComparisonScene lost() {
  constexpr int kTimes = 10;
  constexpr double kPeriod = 0.04, kAway = 0.002;  // s
  const SlabSetup setup = comparison_slab();
  ComparisonScene scene =
      hard("lost-and-regained", "gravity is turned round for 2 ms, 25 times a second", setup);
  const Vec3 full = load(setup.slope, 0.0);
  for (int k = 0; k < kTimes; ++k) {
    const double begins = kBegins + kPeriod * k;
    then(scene, begins, full);
    then(scene, begins + kTimeStep, -full);
    then(scene, begins + kAway, -full);
    then(scene, begins + kAway + kTimeStep, full);
  }
  return scene;
}

ComparisonScene near_cone(double share, const std::string& name) {
  SlabSetup setup = comparison_slab();
  setup.slope = std::atan(share * setup.friction);
  return hard("near-cone/r=" + name, "the load is " + name + " of what friction can hold", setup);
}

ComparisonScene noisy() {
  ComparisonScene scene =
      hard("noise", "each depth is wrong by up to 1 % in each step", comparison_slab());
  scene.settings["depth-noise"] = "0.01";
  return scene;
}

}  // namespace

std::vector<Case> comparisons_hard() {
  std::vector<Case> cases;
  for (const ComparisonScene& scene :
       {perpendicular(), rotating(), switching(), lost(), near_cone(0.98, "0.98"),
        near_cone(0.995, "0.995"), noisy()}) {
    cases.push_back({.name = "hard/" + scene.name,
                     .title = scene.title,
                     .variants = all_rules(),
                     .run = [scene](CaseRun& run) { report_history(run, run_rule(run, scene)); }});
  }
  return cases;
}

}  // namespace stiction
