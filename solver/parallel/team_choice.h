// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "solver/parallel/team.h"

namespace stiction {

/// Who does the steps of a simulation: a team, or the caller alone where the team would not be worth its
/// processors. That depends on the scene, on what else the machine does, and on how far apart its
/// processors are, which on one shared with others changes within minutes. So both are timed as the
/// steps go on, a few steps each in turn: soon after the first, and then ever more seldom as long as
/// the answer stays the same. Who does a step doesn't change a bit of it.
class TeamChoice {
 public:
  using Clock = double (*)();  ///< s

  /// `team` must outlive it. `clock`: that on the wall, but for tests.
  explicit TeamChoice(const Team& team, Clock clock = nullptr);

  /// Before each step: who is to do it; null for the caller alone.
  const Team* begin_step();
  /// Behind each step.
  void end_step();

  /// Who does those that are not timed.
  const Team* chosen() const { return pays_ ? team_ : nullptr; }

  static constexpr int kFirst = 8;   ///< steps before the first trial, while lists and caches fill
  static constexpr int kInARow = 4;  ///< steps of a turn of a trial …
  /// … of which the first are not timed: their data are in the other's caches, and threads that had nothing
  /// to do for 3 ms have to wake. For less than that they look out for work, beside who does it alone.
  static constexpr int kUntimed = 2;
  static constexpr int kTurns = 8;  ///< by the team, alone, alone, by the team, and so again
  static constexpr int kTrial = kTurns * kInARow;
  static constexpr int kSoonest = 64;  ///< steps from a trial to the next after a change …
  static constexpr int kLatest =
      4096;  ///< … and at most, of which a trial is less than a hundredth
  /// A team that takes more of the time than this is not worth its processors, which other programs
  /// could have; and by less than that a trial may be wrong.
  static constexpr double kWorthIt = 0.95;

 private:
  // Their median bears that something holds up a whole turn.
  static constexpr std::size_t kTimed = kTurns / 2 * (kInARow - kUntimed);
  using Times = std::array<double, kTimed>;  // s

  bool by_team() const { return (step_ / kInARow + 1) / 2 % 2 == 0; }
  void choose();

  const Team* team_;
  Clock clock_;
  bool pays_ = true;
  int wait_ = kFirst;        // steps until the next trial
  int hold_ = kSoonest / 2;  // steps that the last answer was good for
  int step_ = 0;             // of a trial
  bool timed_ = false;       // the step that has begun
  double begun_ = 0.0;       // s
  Times together_{}, alone_{};
};

}  // namespace stiction
