// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/core/case_run.h"
#include "validation/user/user_problem.h"

namespace stiction {

/// Simulates the problem to its end, judges its checks, and keeps its series, kinetic energy and
/// fastest slip; at each value of its sweep; or finds its threshold. Throws InputError with file and
/// line for times that fall into one step of the engine, and for a threshold outside its bracket.
void run_user_problem(CaseRun& run, const UserProblem& user);

/// Steps of this length, s, that the problem's duration takes. Throws InputError for less than one,
/// and for more than can be counted.
std::uint64_t steps_of(const UserProblem& user, double time_step);

/// About how many times the problem is simulated.
int simulations_of(const UserProblem& user);

}  // namespace stiction
