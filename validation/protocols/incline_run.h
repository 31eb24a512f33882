// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <vector>

#include "validation/core/case_run.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

/// tan θ at azimuth and yaw in degrees, as they stand in case names.
constexpr double radians(double degrees) { return degrees / 180.0 * std::numbers::pi; }

/// A simulated incline, seen along its slope.
class InclineRun {
 public:
  InclineRun(CaseRun& run, const InclineSetup& setup, const Problem& problem,
             const Accuracy& accuracy = {});

  void advance_to(double time) { simulation_->advance_to(time); }
  void record_frames(double interval) { simulation_->record_frames(interval); }
  double time() const { return simulation_->time(); }
  double time_step() const { return simulation_->engine().time_step(); }
  double travel() const;  ///< downhill from the start, m
  double speed() const;   ///< downhill, m/s
  const Engine& engine() const { return simulation_->engine(); }
  bool tells_contacts() const { return tells_contacts_; }

 private:
  CaseRun::Running simulation_;
  InclineFrame frame_;
  double start_;
  bool tells_contacts_;
};

/// Records what the paper observes: kinetic energy, and, where the engine tells its contacts, the
/// slip speed of the body's contacts (the fastest one), over time; the downhill speed beside them.
class InclineSeries {
 public:
  void sample(const InclineRun& run);
  void add_to(CaseRun& run) const;

 private:
  std::vector<double> time_, kinetic_, slip_, speed_;
};

/// Runs to `end`, sampling about `samples` times from the present on.
void advance_sampled(InclineRun& run, double end, int samples, InclineSeries& series);

}  // namespace stiction
