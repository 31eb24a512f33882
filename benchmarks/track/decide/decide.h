// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "benchmarks/track/decide/metric.h"

namespace stiction::track {

enum class Change { kSame, kWorse, kBetter };

/// One metric of two revisions, side by side.
struct Comparison {
  Metric metric;
  double before = 0.0;  ///< median of the samples, in the metric's unit
  double after = 0.0;
  double low = 0.0, high = 0.0;  ///< 95 % interval of after/before; of times alone
  double p = 1.0;                ///< exact, two-sided Mann–Whitney; of times alone
  /// |ln(after/before)| that the run could not have told from noise; of times alone.
  double floor = 0.0;
  Change change = Change::kSame;
  bool refuted = false;  ///< a first run said worse or better, the second did not

  double ratio() const { return after / before; }
  /// How bad it is, to sort by: ln of the cost ratio, digits lost × ln 10, or 100 × ranks of a
  /// verdict. Positive is worse.
  double badness() const;
};

/// When a loss counts. Each has its reason in decide.cpp.
struct Limits {
  double significance;   ///< largest p of a change in time
  double layout_floor;   ///< smallest change of a time that is called one, |ln ratio|
  double count_margin;   ///< growth of a count that is let pass, relative
  double digits_margin;  ///< digits lost that are let pass
};
extern const Limits kLimits;

/// Compares two measurements of one metric.
///  * Times: a change when p ≤ significance, the bootstrap interval of the ratio of medians
///  excludes
///    1, and |ln ratio| is above the noise floor of both samples and above the layout floor.
///  * Counts, digits and verdicts are deterministic: beyond the margin they have changed.
/// Throws std::invalid_argument for a time that is not positive, or below four samples of one.
Comparison compare(const Measurement& before, const Measurement& after);

/// All metrics that both have, worst first.
std::vector<Comparison> compare(const Measurements& before, const Measurements& after);

/// What is in `a` and not in `b`, names in order.
std::vector<std::string> missing(const Measurements& a, const Measurements& b);

/// Keeps a change of a time only where an independent second run found the same one; else it is
/// kSame and `refuted`.
void confirm(std::vector<Comparison>& first, const std::vector<Comparison>& second);

bool any(const std::vector<Comparison>& comparisons, Change change);
void sort_worst_first(std::vector<Comparison>& comparisons);

}  // namespace stiction::track
