// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "validation/core/case_run.h"

namespace stiction {

/// Judges a claim by the largest of what `value` gives of each run, or by what is no number. A run
/// has `words`, by which it is named. `all`: one or more.
template <class Run, class Value>
void check_worst(CaseRun& run, const std::vector<Run>& all, Claim claim, Value value) {
  const Run* worst = &all.front();
  for (const Run& one : all) {
    if (!(value(one) <= value(*worst))) worst = &one;
  }
  run.check(std::move(claim), value(*worst), worst->words);
}

}  // namespace stiction
