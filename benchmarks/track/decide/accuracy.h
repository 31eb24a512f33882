// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "benchmarks/track/decide/metric.h"
#include "benchmarks/track/measure/tree.h"
#include "benchmarks/track/store/history.h"
#include "reports/record/record.h"

namespace stiction::track {

/// What `validate` computed of a revision.
struct CaseAccuracy {
  Measurements measurements;
  /// End state of each subject, 16 hex digits: equal in two revisions when every bit is.
  std::map<std::string, std::string> state_hash;
  Machine machine;  ///< as the records tell
};

/// Which cases to run: options of `validate`, e.g. {"--quick"} or {"--case", "slab/*"}.
using CaseOptions = std::vector<std::string>;

/// Runs `validate`; deterministic, so remembered by the program's content and the machine unless
/// `fresh`. Throws TrackError when it could not run; cases that fail are no such failure.
CaseAccuracy measure_accuracy(const Tree& tree, const CaseOptions& options, const Project& project,
                              bool fresh);

/// The metrics of records. A subject is a case and as few settings as tell its records from each
/// other, "case@rule=none": a default that changes with a revision is compared all the same.
///  * verdict            of the record, and of each check ("verdict: creep")
///  * digits: <quantity> of checks that must hold; those shown, or known to be short of the claim,
///                       may move: their limit cycles depend on the last bit
///  * digits within tolerance: <quantity>
///                       the same where zero is expected of a quantity without a scale: how many
///                       powers of ten the error is below its tolerance, at most 3
///  * contact updates    of the case
///  * <quantity>         where a check counts steps, e.g. to convergence
/// Digits are clipped at the round-off floor −log₁₀(steps · 2.2e-16): so much error n additions
/// can make, and which part of it they do make changes with every reordering.
CaseAccuracy accuracy_of(const std::vector<Record>& records);

}  // namespace stiction::track
