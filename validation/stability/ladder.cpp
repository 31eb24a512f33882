// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/stability/ladder.h"

#include <fmt/format.h>

#include <algorithm>

#include "solver/demand.h"
#include "validation/observe/rest_watch.h"
#include "validation/problems/ladder_problem.h"

namespace stiction {

namespace {

// An engine that says it cannot go farther has come to its last rung, and said so.
void climb(CaseRun& run, const std::function<void(CaseRun&, double)>& rung, double value) {
  std::string refusal;
  try {
    rung(run, value);
  } catch (const NotApplicable&) {
    throw;
  } catch (const InputError& error) {
    refusal = error.what();
  }
  if (refusal.empty()) return;
  run.check({.quantity = "refused",
             .unit = "1",
             .statement = "the engine takes it",
             .formula = "no refusal",
             .source = "a valid scene",
             .kind = ReferenceKind::kAnalytic,
             .expected = 0.0,
             .tolerance = 0.0,
             .reason = "a count"},
            1.0, refusal);
}

bool among(const std::vector<double>& values, double value) {
  return std::find(values.begin(), values.end(), value) != values.end();
}

}  // namespace

std::vector<Case> rungs_of(const Ladder& ladder) {
  for (const double value : ladder.quick) {
    demand(among(ladder.rungs, value), "a ladder's quick rung is none of its rungs");
  }
  std::vector<Case> all;
  for (std::size_t k = 0; k < ladder.rungs.size(); ++k) {
    const double value = ladder.rungs[k];
    const bool long_one = k + ladder.only_full >= ladder.rungs.size();
    const bool short_one = among(ladder.quick, value);
    all.push_back({.name = fmt::format("ladder/{}/{}={:g}", ladder.name, ladder.parameter, value),
                   .title = fmt::format("{}: {} = {:g}", ladder.words, ladder.parameter, value),
                   .set = short_one  ? CaseSet::kQuick
                          : long_one ? CaseSet::kFull
                                     : CaseSet::kDefault,
                   .suite = "stability",
                   .run = [run = ladder.run, value](CaseRun& given) { climb(given, run, value); }});
  }
  return all;
}

void append(std::vector<Case>& all, const Ladder& ladder) {
  for (Case& one : rungs_of(ladder)) all.push_back(std::move(one));
}

void check_ladder_rest(CaseRun& run, const Problem& problem, const std::string& claim,
                       double length, const Accuracy& accuracy) {
  const RestScene scene{.words = fmt::format("from {:g} s on", kLadderSettled),
                        .problem = problem,
                        .accuracy = accuracy,
                        .settled = kLadderSettled,
                        .window = kLadderWindow};
  check_rest(run, watch_rest(run, scene, kOnce, 0.5 * length),
             {.drift = 1e-9 * kLadderWindow,
              .drift_reason = "the paper's 1e-9 m/s of static contacts over the window of 1 s",
              .slip = 1e-9,
              .slip_reason = "the paper's 1e-9 m/s of static contacts",
              .claim = claim});
}

}  // namespace stiction
