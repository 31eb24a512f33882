// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reports/record/record.h"
#include "validation/core/case_run.h"
#include "validation/problems/piles/ball_pyramid_problem.h"

namespace stiction {

/// When what happens, s. Balls that roll from facet to facet swing for seconds, for nothing but
/// strain damps that; so they settle in a medium, at a friction under which nothing slips, and once
/// more in it at the friction of the question. It is gone before anything is judged.
struct BallPyramidTimes {
  double lowered = 1.2;  ///< friction falls from `kSettlingFriction` to that of the question
  double fading = 1.8;   ///< the medium begins to fade
  double settled = 2.2;  ///< it is gone: judged from here
  double watched = 5.0;  ///< long
};

/// Above what any contact needs, however its facet is inclined.
inline constexpr double kSettlingFriction = 1.0;

/// What became of the pyramid at one μ.
struct BallPyramidOutcome {
  bool stands = true;
  double sunk = 0.0;               ///< the top ball, since friction was lowered, m
  double spread = 0.0;             ///< the lower balls outwards, since then, m
  double ground_slip = 0.0;        ///< while it breaks, by normal force, m/s
  double outward = 0.0;            ///< … of the lower balls' centres, m/s
  double kinetic[2] = {0.0, 0.0};  ///< mean of each half of the window, J
  double freed = 0.0;              ///< by the top ball's sinking in the window, J
  double pair_slip = 0.0;          ///< at the end, between balls, by normal force, m/s
  /// μ that smooth rigid balls with centres there need: when judging begins, and at the end.
  double needed_first = 0.0;
  double needed_last = 0.0;
  /// If it stands: least μ of its contacts, mean of the last second. Infinite where the pressures
  /// are out of balance by more than `kMovingResidual`: then it still moves.
  reference::LimitBracket any_loads{};
  reference::LimitBracket measured_loads{};

  /// How much of what is left of the friction a window like this one uses up; more than 1 would
  /// break it.
  double used(double friction) const {
    return (needed_last - needed_first) / (friction - needed_last);
  }
};

/// Settles the pyramid once; each question goes on from there.
class BallPyramidRun {
 public:
  BallPyramidRun(CaseRun& run, const BallPyramidSetup& setup, const BallPyramidTimes& times = {});

  /// Lowers μ to `friction` and watches; the record gets the histories on demand.
  BallPyramidOutcome continue_with(double friction, bool keep_series);

  const BallPyramidSetup& setup() const { return setup_; }
  const BallPyramidTimes& times() const { return times_; }
  double broken_at() const;  ///< the top ball has sunk so far, m

 private:
  CaseRun::Running simulate(double friction);
  double top_weight() const;  // N

  CaseRun& run_;
  BallPyramidSetup setup_;
  BallPyramidTimes times_;
  Snapshot start_;
  PyramidShape shape_;
};

}  // namespace stiction
