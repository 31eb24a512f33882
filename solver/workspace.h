// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <vector>

#include "solver/contacts.h"
#include "solver/state.h"

namespace stiction {

/// The phases of a step, in order.
enum class Phase { kForces, kPredict, kDetect, kNormalForce, kFriction, kIntegrate };
inline constexpr std::array<const char*, 6> kPhaseNames = {"forces",       "predict",  "detect",
                                                           "normal force", "friction", "integrate"};

/// Wall-clock time spent in each phase, s.
using PhaseSeconds = std::array<double, kPhaseNames.size()>;

/// Adds the life of the object to a phase's time; does nothing when there is no clock to add to.
class PhaseTimer {
 public:
  PhaseTimer(PhaseSeconds* seconds, Phase phase)
      : total_(seconds ? &(*seconds)[static_cast<std::size_t>(phase)] : nullptr) {
    if (total_) start_ = std::chrono::steady_clock::now();
  }
  ~PhaseTimer() {
    if (!total_) return;
    *total_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  PhaseTimer(const PhaseTimer&) = delete;
  PhaseTimer& operator=(const PhaseTimer&) = delete;

 private:
  double* total_;
  std::chrono::steady_clock::time_point start_;
};

/// Scratch memory of a step, kept so that a warm step allocates nothing, and what the last step
/// did. Nothing in it is needed to continue from a State.
struct Workspace {
  std::vector<Vec3> force;                ///< per vertex, N: gravity and elasticity at _t0
  std::vector<Velocity> velocity;         ///< per vertex: v*, corrected in place to v_t1
  OneSidedContacts contacts;              ///< of the last step
  FrictionMemory memory;                  ///< the memory being written
  std::uint64_t contact_updates = 0;      ///< summed over steps
  PhaseSeconds* phase_seconds = nullptr;  ///< where to add times; null: nothing is timed
};

}  // namespace stiction
