// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stiction {

/// What a document shows of several values: the checks of one case, and then the cases.
enum class Taken {
  kOnly,   ///< there must be one
  kLeast,  ///< infinities (never) count as large; a value that is no number wins
  kMost,   ///< the same
  kRange,  ///< least and most
  kCount,  ///< how many there are
};

/// How a number stands in a document.
struct FigureStyle {
  int digits = 1;              ///< significant ones
  int places = -1;             ///< behind the point; −1: by `digits`
  double times = 1.0;          ///< multiplied by before it is shown, e.g. 100 for per cent
  bool decades = false;        ///< shown as −log₁₀: digits of what scatters so; of 0 "exact"
  bool sign = false;           ///< a + before positive ones
  std::string unit{};          ///< behind it, e.g. " %"
  std::string range = " to ";  ///< between the ends of a range
  /// Words for what is above a value, e.g. {0.01, "slips out"}; the highest that is passed counts.
  std::map<double, std::string> above{};
  std::string no_number = "–";  ///< word for NaN
  std::string never = "never";  ///< word for infinity
};

/// A figure of the documents: which number of a run's records it is.
struct FigureRule {
  std::string name{};   ///< "rest-poses@quiet": name of the rule, and of the column if it has any
  std::string where{};  ///< "validate.toml:12", for messages
  std::string case_glob{};                        ///< of the records' cases
  std::string except{};                           ///< glob of cases left out; empty: none
  std::map<std::string, std::string> settings{};  ///< that a record must have; "" is 'not set'
  std::string quantity{};                         ///< of a check or a figure …
  std::string series{};                           ///< … or of a series, at x = `at`
  double at = 0.0;
  Taken within = Taken::kOnly;  ///< of the records and checks of one case
  Taken over = Taken::kOnly;    ///< of the cases
  bool may_lack = false;        ///< a case without the quantity is left out
  /// A fresh run agrees while it is within a factor of `factor` (10: the same order of magnitude),
  /// or both are below `floor` in size, where rounding decides.
  double factor = 10.0;
  double floor = 0.0;
  FigureStyle style{};
};

/// What a document shows of a whole run.
enum class Shown {
  kSummary,           ///< "summary": the summary screen
  kCheapestSettings,  ///< "cheapest-settings": of each question, in Markdown (formats/work_precision.h)
};

/// Lines that are made of a run's records.
struct SampleRule {
  std::string name{};
  std::string where{};
  std::string run_of{};  ///< a case that the run has
  Shown shows = Shown::kSummary;
};

/// One program's figures: reports/documents/figures/<program>.toml.
struct FigureRules {
  std::string program{};  ///< "validate"
  std::vector<FigureRule> figures{};
  std::vector<SampleRule> samples{};
  /// Names of the columns of each rule that has any, in the order in which they were given.
  std::map<std::string, std::vector<std::string>> columns{};
};

/// Reads such a file. Throws std::runtime_error "FILE:LINE: SENTENCE" for what it does not know.
FigureRules read_figure_rules(const std::filesystem::path& file);

}  // namespace stiction
