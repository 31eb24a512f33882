// SPDX-License-Identifier: BSD-3-Clause
#include "solver/parallel/team_choice.h"

#include <algorithm>
#include <chrono>

namespace stiction {

namespace {

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

TeamChoice::TeamChoice(const Team& team, Clock clock)
    : team_(&team), clock_(clock == nullptr ? wall_seconds : clock) {}

const Team* TeamChoice::begin_step() {
  timed_ = false;
  if (wait_ > 0) {
    --wait_;
    return chosen();
  }
  timed_ = true;
  begun_ = clock_();
  return by_team() ? team_ : nullptr;
}

void TeamChoice::end_step() {
  if (!timed_) return;
  timed_ = false;
  if (step_ % kInARow >= kUntimed) {
    Times& times = by_team() ? together_ : alone_;
    times.seconds[times.count++] = clock_() - begun_;
  }
  if (++step_ == kTurns * kInARow) choose();
}

void TeamChoice::choose() {
  const bool pays = together_.median() <= kWorthIt * alone_.median();
  hold_ = pays == pays_ ? std::min(2 * hold_, kLatest) : kSoonest;
  pays_ = pays;
  wait_ = hold_;
  step_ = 0;
}

double TeamChoice::Times::median() {
  std::sort(seconds.begin(), seconds.end());
  count = 0;
  return 0.5 * (seconds[(kTimed - 1) / 2] + seconds[kTimed / 2]);
}

}  // namespace stiction
