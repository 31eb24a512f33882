// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "validation/core/case_run.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

/// A box on a deformable slab whose bottom is held: both sides of the contact give way. The slab's
/// top is the plane z = 0; the slope is made by turning gravity, so that meshes and contacts do not
/// depend on it.
struct SlabSetup {
  double slope = 0.0;            ///< θ, rad
  double azimuth = 0.0;          ///< direction in which the slope falls, rad from x about z
  double yaw = 0.0;              ///< of the box about z, rad
  Vec3 offset = Vec3::Zero();    ///< of the box from the slab's middle, m; z is ignored
  Vec3 box_size{0.1, 0.1, 0.1};  ///< m; 1000 kg/m³, so the cube weighs 1 kg
  int cells = 3;                 ///< along the box's longest edge
  int slab_cells = 4;     ///< along the slab's length and width; it has one or more in height
  int slab_layers = 1;    ///< cells through the slab's height
  double friction = 0.5;  ///< μ
  Elasticity elasticity{.youngs_modulus = 2e5, .poisson_ratio = 0.3, .damping_time = 2e-3};
  SettledLoad load;    ///< gravity comes into the slab first, then along it
  double speed = 0.0;  ///< of the box downhill at t = 0, m/s
};

inline constexpr double kSlabWidth = 0.2;  ///< of the slab along x and y, m

/// Unit vector along the slab in which gravity pulls the box.
Vec3 slab_downhill(const SlabSetup& setup);

/// Bodies: the box (0) and the slab (1).
Problem slab_problem(const SlabSetup& setup);

/// What the contact between box and slab does at one time.
struct SlabSample {
  double time = 0.0;          ///< s
  double mean_slip = 0.0;     ///< of the loaded contacts, m/s
  double fastest_slip = 0.0;  ///< … the fastest of them
  double kinetic = 0.0;       ///< of box and slab, J
  int contacts = 0;           ///< loaded ones
  int sliding = 0;            ///< … of which the engine says that they slip
};

/// A simulated box on a slab.
class SlabRun {
 public:
  /// `over`: what a study or a control lays over the run's settings.
  SlabRun(CaseRun& run, const SlabSetup& setup, Accuracy accuracy = {}, const Settings& over = {});

  void advance_to(double time) { simulation_->advance_to(time); }
  void record_frames(double interval) { simulation_->record_frames(interval); }
  double time() const { return simulation_->time(); }
  double time_step() const { return simulation_->engine().time_step(); }
  Vec3 travel() const;   ///< of the box from its start, m
  double speed() const;  ///< of the box downhill, m/s
  SlabSample sample() const;
  Engine& engine() { return simulation_->engine(); }

 private:
  CaseRun::Running simulation_;
  Vec3 downhill_;
  Vec3 start_;
};

/// Histories of mean and fastest slip and of kinetic energy.
class SlabSeries {
 public:
  void add(const SlabSample& sample) { samples_.push_back(sample); }
  void add_to(CaseRun& run, const std::string& suffix = "") const;

 private:
  std::vector<SlabSample> samples_;
};

/// 20° steep, the coarse box yawed by 17° and off the middle, so that its mesh and the slab's have
/// no line in common.
SlabSetup slab_at_20_degrees();

/// Twelve chosen poses: level to 26°, aligned and yawed, centred and not.
std::vector<SlabSetup> fixed_slabs();

/// `count` seeded poses: slope 0°–26°, any azimuth and yaw, 2 to `most_cells` cells, box edges
/// 0.08–0.12 m, slab of 3 to `most_cells` + 2 cells.
std::vector<SlabSetup> random_slabs(int count, int most_cells, std::uint32_t seed);

/// "20.0° yaw 17° cells 3 …": where the worst offender stood.
std::string slab_words(const SlabSetup& setup);

}  // namespace stiction
