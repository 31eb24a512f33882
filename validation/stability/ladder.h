// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "validation/core/case_run.h"

namespace stiction {

/// A parameter swept over decades until something breaks: each rung a case of the suite "stability",
/// "ladder/<name>/<parameter>=<value>", so that a rung is run again by its name.
struct Ladder {
  std::string name;       ///< "mass-ratio"
  std::string parameter;  ///< "top"
  std::string words;  ///< what holds on each rung: "a box rests under one so many times as heavy"
  std::vector<double> rungs;
  /// Those that run with --quick.
  std::vector<double> quick{};
  /// The last rungs, which take long: with --full alone.
  std::size_t only_full = 0;
  std::function<void(CaseRun&, double)> run;
};

std::vector<Case> rungs_of(const Ladder& ladder);
void append(std::vector<Case>& all, const Ladder& ladder);

/// That a scene rests from kLadderSettled on, to what the paper calls static: 1e-9 m/s. `length`: half
/// of it is how far a body may go before the run is given up, m.
void check_ladder_rest(CaseRun& run, const Problem& problem, const std::string& claim,
                       double length = 0.1, const Accuracy& accuracy = {});

}  // namespace stiction
