// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/slopes/slab_problem.h"

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "reference/meshes/box_mesh.h"
#include "validation/observe/observe.h"
#include "validation/protocols/incline_run.h"

namespace stiction {

namespace {

constexpr double kDensity = 1000.0;                  // kg/m³
const Vec3 kSlabSize{kSlabWidth, kSlabWidth, 0.05};  // m

double in_degrees(double angle) { return angle * 180.0 / std::numbers::pi; }

}  // namespace

Vec3 slab_downhill(const SlabSetup& setup) {
  return {std::cos(setup.azimuth), std::sin(setup.azimuth), 0.0};
}

Problem slab_problem(const SlabSetup& setup) {
  const Vec3 downhill = slab_downhill(setup);
  ProblemBody box;
  box.name = "box";
  box.shape = BoxShape{setup.box_size};
  box.mass = kDensity * setup.box_size.prod();
  box.elasticity = setup.elasticity;
  box.position = Vec3(setup.offset.x(), setup.offset.y(), 0.5 * setup.box_size.z());
  box.rotation = Eigen::AngleAxisd(setup.yaw, Vec3::UnitZ());
  box.velocity = setup.speed * downhill;

  // Its own mesh, whatever the engine's resolution: the two sides shall not match.
  ProblemBody slab;
  slab.name = "slab";
  slab.shape = MeshShape{
      reference::box_mesh(kSlabSize, {setup.slab_cells, setup.slab_cells, setup.slab_layers})};
  slab.mass = kDensity * kSlabSize.prod();
  slab.elasticity = setup.elasticity;
  slab.position = Vec3(0.0, 0.0, -0.5 * kSlabSize.z());
  slab.held = HeldPart{Vec3(0.0, 0.0, -0.5 * kSlabSize.z()), Vec3::UnitZ()};

  const Vec3 normal = -kStandardGravity * std::cos(setup.slope) * Vec3::UnitZ();
  const Vec3 full = normal + kStandardGravity * std::sin(setup.slope) * downhill;
  Problem problem;
  problem.name = "slab";
  problem.bodies = {box, slab};
  problem.friction = setup.friction;
  problem.gravity = {
      {0.0, setup.load.normal_full, setup.load.tangential_from, setup.load.tangential_full},
      {Vec3::Zero(), normal, normal, full}};
  return problem;
}

SlabRun::SlabRun(CaseRun& run, const SlabSetup& setup, Accuracy accuracy, const Settings& over)
    : downhill_(slab_downhill(setup)) {
  accuracy.fineness = setup.cells;
  simulation_ = run.simulate_with(over, slab_problem(setup), accuracy);
  start_ = simulation_->engine().body(0).position;
}

Vec3 SlabRun::travel() const { return simulation_->engine().body(0).position - start_; }

double SlabRun::speed() const { return downhill_.dot(simulation_->engine().body(0).velocity); }

SlabSample SlabRun::sample() const {
  const ContactSlips slips = slips_of(simulation_->engine().contacts());
  return {.time = time(),
          .mean_slip = slips.mean,
          .fastest_slip = slips.fastest,
          .kinetic = simulation_->engine().kinetic_energy(),
          .contacts = slips.contacts,
          .sliding = slips.sliding};
}

void SlabSeries::add_to(CaseRun& run, const std::string& suffix) const {
  std::vector<double> time, mean, fastest, kinetic;
  for (const SlabSample& sample : samples_) {
    time.push_back(sample.time);
    mean.push_back(sample.mean_slip);
    fastest.push_back(sample.fastest_slip);
    kinetic.push_back(sample.kinetic);
  }
  run.add({"kinetic energy" + suffix, "J", "time", "s", time, kinetic});
  run.add({"fastest contact slip" + suffix, "m/s", "time", "s", time, fastest});
  run.add({"mean contact slip" + suffix, "m/s", "time", "s", time, mean});
}

SlabSetup slab_at_20_degrees() {
  SlabSetup setup;
  setup.slope = radians(20.0);
  setup.yaw = radians(17.0);
  setup.offset = Vec3(0.013, 0.007, 0.0);
  setup.cells = 2;
  setup.slab_cells = 3;
  return setup;
}

std::vector<SlabSetup> fixed_slabs() {
  std::vector<SlabSetup> setups;
  // Aligned and centred comes first: every vertex of the box lies on an edge of the slab's mesh.
  const Vec3 offsets[] = {Vec3::Zero(), {0.013, 0.007, 0.0}, {-0.021, 0.017, 0.0}};
  int k = 0;
  for (const double slope : {0.0, 10.0, 20.0, 26.0}) {
    for (const double yaw : {0.0, 17.0, 45.0}) {
      SlabSetup setup;
      setup.slope = radians(slope);
      setup.yaw = radians(yaw);
      setup.azimuth = k % 2 ? radians(30.0) : 0.0;
      setup.offset = offsets[k % 3];
      setup.cells = k % 6 == 4 ? 3 : 2;
      setup.slab_cells = 3 + (k + 1) % 2;
      setups.push_back(setup);
      ++k;
    }
  }
  return setups;
}

std::vector<SlabSetup> random_slabs(int count, int most_cells, std::uint32_t seed) {
  std::mt19937 generator(seed);
  // The library's distributions differ from compiler to compiler.
  const auto uniform = [&](double from, double to) {
    return from + (to - from) * (static_cast<double>(generator()) / 4294967296.0);
  };
  const auto whole = [&](int from, int to) {
    return from + static_cast<int>(generator() % static_cast<std::uint32_t>(to - from + 1));
  };
  std::vector<SlabSetup> setups;
  for (int k = 0; k < count; ++k) {
    SlabSetup setup;
    setup.slope = radians(uniform(0.0, 26.0));
    setup.azimuth = radians(uniform(0.0, 360.0));
    setup.yaw = radians(uniform(0.0, 90.0));
    const double x = uniform(-0.02, 0.02), y = uniform(-0.02, 0.02);
    setup.offset = Vec3(x, y, 0.0);
    const double a = uniform(0.08, 0.12), b = uniform(0.08, 0.12), c = uniform(0.08, 0.12);
    setup.box_size = Vec3(a, b, c);
    setup.cells = whole(2, most_cells);
    setup.slab_cells = whole(3, most_cells + 2);
    setups.push_back(setup);
  }
  return setups;
}

std::string slab_words(const SlabSetup& setup) {
  return fmt::format("slope {:.1f}°, azimuth {:.0f}°, yaw {:.0f}°, {} cells on {}",
                     in_degrees(setup.slope), in_degrees(setup.azimuth), in_degrees(setup.yaw),
                     setup.cells, setup.slab_cells);
}

}  // namespace stiction
