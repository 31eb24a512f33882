// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "validation/engine/engine.h"
#include "validation/user/user_problem.h"

namespace stiction {

/// What a problem will take on an engine.
struct UserEstimate {
  double time_step = 0.0;    ///< s
  std::uint64_t steps = 0;   ///< of one simulation
  int simulations = 1;       ///< of a threshold or a sweep
  double cpu_seconds = 0.0;  ///< of all, as the first tenth of a second of them went
  std::uint64_t tetrahedra = 0;
};

/// "0.57 s", "5 min", "3 h", "2.5 days": of an estimate.
std::string time_text(double seconds);

/// Loads the problem and takes its first steps. Throws what the engine says when it refuses it, and
/// InputError as steps_of does.
UserEstimate estimate(const UserProblem& user, const EngineKind& engine, const Settings& settings,
                      double finer = 1.0);

/// "10000 steps of 0.2 ms, about 3 s of CPU time".
std::string estimate_text(const UserEstimate& estimate);

/// The problem in words, for who wrote its file: what there is, where it begins, what is claimed.
/// Lines of at most `width` columns where a word allows it.
std::string explained(const UserProblem& user, std::size_t width);

}  // namespace stiction
