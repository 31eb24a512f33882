// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/record/record.h"
#include "reports/screen/screen.h"

namespace stiction {

// Work and precision of questions that a person asks (the comparisons work-precision/): what a run
// cost, and how far its answer is off. A case is named PREFIX QUESTION/PARAMETER=VALUE/…, and its
// records have these figures.

inline constexpr const char* kWorkPrecision = "work-precision/";
/// The error, and beside it what it can't be told from: no error is told as smaller than that, and
/// none as zero.
inline constexpr const char* kErrorAtMost = "error at most";
/// Uncertainty of the reference, and resolution of the measurement.
inline constexpr const char* kErrorDoubt = "of which uncertain";
inline constexpr const char* kWorkTime = "CPU time";  ///< s a simulated second
inline constexpr const char* kWorkSpread = "CPU time, slowest ÷ fastest";

/// For which errors the cheapest setting is looked for.
inline constexpr std::array<double, 3> kPrecisions{1e-3, 1e-6, 1e-9};

/// One run of a question.
struct WorkPoint {
  std::string question;  ///< "stopping-distance"
  std::string method;    ///< "quiet", "quiet ×8": with so many sweeps, not with its own number
  /// Those of the case's name, in its order: {"cells", "2"}, {"dt", "1e-4"}.
  std::vector<std::pair<std::string, std::string>> parameters;
  double seconds = 0.0;  ///< CPU time a simulated second
  double error = 0.0;    ///< at most; in `unit`
  double doubt = 0.0;    ///< of which uncertain
  double spread = 1.0;   ///< slowest repetition over the fastest
  std::string unit;      ///< "1" for a relative error
  std::string broken;    ///< why it is no answer; empty: it is one
};

/// Those of the records that are such runs, a list a question, sorted by its name.
std::vector<std::vector<WorkPoint>> work_points(const std::vector<Record>& records);

/// The Pareto front of one question's runs, cheapest first: none is both cheaper and as precise, and
/// each is more precise than all that are cheaper. What broke is never among them.
std::vector<WorkPoint> work_front(const std::vector<WorkPoint>& points);

/// The cheapest whose error is `precision` at most; none where nothing that did not break is.
std::optional<WorkPoint> cheapest_setting(const std::vector<WorkPoint>& points, double precision);

/// Where there is none: the cheapest that can't be told from the most precise, by what that one's
/// error is uncertain. None where every run broke.
std::optional<WorkPoint> most_precise_setting(const std::vector<WorkPoint>& points);

/// Methods that are as precise as asked for too, and no dearer than `chosen` by more than costs
/// differ from one repetition to the next; `chosen`'s own left out.
std::vector<std::string> as_cheap(const std::vector<WorkPoint>& points, const WorkPoint& chosen,
                                  double precision);

/// A row a question and the precisions that one setting is cheapest for: its CPU time, error and
/// parameters; where no setting has such an error "none, best" and most_precise_setting(). The first row
/// is the heading. Empty without such records.
/// With `ties` a last column names the methods that are as cheap.
Cells cheapest_settings(const std::vector<Record>& records, bool ties = false);

/// The same for a terminal, with what broke below it.
std::string cheapest_settings_screen(const std::vector<Record>& records, const Screen& screen);

/// The same as a table in Markdown.
std::string cheapest_settings_markdown(const std::vector<Record>& records);

/// That under a heading, then the front of each question. Empty without such records.
std::string work_precision_markdown(const std::vector<Record>& records);

}  // namespace stiction
