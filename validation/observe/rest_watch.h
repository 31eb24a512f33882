// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "validation/core/case_run.h"

namespace stiction {

/// A scene that must come to rest and stay there.
struct RestScene {
  std::string words;  ///< which of a case's scenes: "7 cubes at 2.0°"
  Problem problem;
  Accuracy accuracy{};
  double settled = 6.0;  ///< time at which rest is due, s
  double window = 10.0;  ///< it is watched from then on, s
};

/// How a verdict of rest is asked for again: it must survive all of them.
struct Asked {
  bool twice_the_window = false;
  bool half_the_step = false;
};
inline constexpr Asked kOnce{}, kDoubled{true, true};

/// What a scene did in its window.
struct RestOutcome {
  std::string words;          ///< of the scene, with "twice the window" or "half the step"
  double drift = 0.0;         ///< of the centre that moved farthest, m; ∞ when it diverged
  std::string drifter;        ///< its body
  double fastest_slip = 0.0;  ///< of any loaded contact in the last tenth of the window, m/s
  double growth = 0.0;        ///< of the kinetic energy (EnergyWatch)
  double growth_allowed = 0.0;
  double kinetic = 0.0;  ///< mean in the second half, J
  double moved = 0.0;    ///< of the centre that moved farthest since t = 0, m
  std::string broken;    ///< why it was given up before the end; empty if it wasn't
  std::vector<ContactSample> contacts{};  ///< at the end
  std::vector<BodyMotion> motion{};       ///< of each body, at the end
};

/// Simulates one scene once, twice with half the step; outcomes in the order base, twice the
/// window, half the step. A scene of which a body moves by more than `given_up` (m) is not
/// simulated to its end. The first simulation is recorded, and its histories are added.
std::vector<RestOutcome> watch_rest(CaseRun& run, const RestScene& scene, const Asked& asked,
                                    double given_up, bool shown = true);

/// What rest means in a case.
struct RestBounds {
  double drift = 1e-8;  ///< m
  std::string drift_reason;
  double slip = 1e-12;  ///< m/s
  std::string slip_reason;
  std::string source = "Coulomb's law and static equilibrium";
  std::string claim;  ///< "a flush stack rests"
};

/// Drift, slip and growth of energy of the worst, and, of several, the share at rest; a note with
/// median and worst.
void check_rest(CaseRun& run, const std::vector<RestOutcome>& outcomes, const RestBounds& bounds);

}  // namespace stiction
