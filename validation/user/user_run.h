// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "validation/core/case_run.h"
#include "validation/observe/observe.h"

namespace stiction {

/// A claim of a person's problem and what of which body it is about, when.
struct UserCheck {
  Claim claim{};
  const Observable* observable = nullptr;
  std::size_t body = 0;
  Vec3 direction = Vec3::Zero();  ///< unit, of observables along one
  double from = 0.0;              ///< s; of observables over a window
  double at = 0.0;                ///< s
};

/// A problem of one's own as it was read.
struct UserProblem {
  Problem problem{};
  std::vector<Vec3> downhill{};  ///< one an obstacle, unit
  Settings settings{};           ///< of the engine
  std::vector<UserCheck> checks{};
  std::string title{};
};

/// Simulates it to the end, judges its checks, and keeps its kinetic energy and fastest slip.
void run_user_problem(CaseRun& run, const UserProblem& user);

}  // namespace stiction
