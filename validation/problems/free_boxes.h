// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "validation/core/case_run.h"
#include "validation/engine/problem.h"

namespace stiction {

/// A cube of 0.1 m and 1 kg, 0.5 MPa stiff, that flies freely until it meets another.
/// `damping_time`: β, s.
ProblemBody free_cube(const char* name, const Vec3& position, const Vec3& velocity,
                      double damping_time,
                      const Eigen::Quaterniond& rotation = Eigen::Quaterniond::Identity());

/// No gravity, nothing held, μ = 0.5: all momentum stays in the bodies. `duration`: s.
Problem free_problem(const char* name, const std::vector<ProblemBody>& bodies, double duration);

/// With 4 cells along a box unless the run's settings say otherwise, recorded every millisecond.
CaseRun::Running simulate_free(CaseRun& run, const Problem& problem, const Settings& over = {});

/// Σ m|v| at the start, kg m/s: what an error of the linear momentum is relative to.
double momentum_scale(const Problem& problem);

}  // namespace stiction
