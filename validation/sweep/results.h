// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reports/record/record.h"
#include "reports/screen/screen.h"
#include "validation/sweep/points.h"

namespace stiction {

/// What a sweep keeps of a point in memory: its record is on disk.
struct PointResult {
  bool known = false;  ///< else another shard's, or still to come
  Verdict verdict = Verdict::kError;
  bool holds = false;  ///< every check, whether or not anybody judges it
  double cpu_seconds = 0.0;
  std::vector<double> values{};  ///< of its checks
};
PointResult result_of(const Record& record);

/// One result a point, in the study's order.
using Results = std::vector<PointResult>;

/// For programs: a line each of the points `told` with its hash, engine, configuration, axes, verdict,
/// CPU seconds and what its checks measured; unknown points have empty cells.
std::string points_csv(const Study& study, const Points& points,
                       const std::vector<std::size_t>& told, const Results& results);

/// For people: how many points hold, engine by engine; and where two axes vary on a grid, which.
std::string results_screen(const Study& study, const Results& results, const Screen& screen);

}  // namespace stiction
