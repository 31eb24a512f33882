// SPDX-License-Identifier: BSD-3-Clause
#include "solver/parallel/team_choice.h"

#include <algorithm>
#include <chrono>

namespace stiction {

namespace {

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

template <class Values>
double median(Values values) {
  std::sort(values.begin(), values.end());
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
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
  const int turn = step_ / kInARow, timed = step_ % kInARow - kUntimed;
  if (timed >= 0) {
    const int place =
        turn / 2 * (kInARow - kUntimed) + timed;  // of each two turns one is of either
    (by_team() ? together_ : alone_)[static_cast<std::size_t>(place)] = clock_() - begun_;
  }
  if (++step_ == kTrial) choose();
}

void TeamChoice::choose() {
  const bool pays = median(together_) <= kWorthIt * median(alone_);
  hold_ = pays == pays_ ? std::min(2 * hold_, kLatest) : kSoonest;
  pays_ = pays;
  wait_ = hold_;
  step_ = 0;
}

}  // namespace stiction
