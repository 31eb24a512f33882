// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/record/record.h"
#include "validation/comparison/engines/questions.h"

namespace stiction {

inline constexpr const char* kOurEngine = "stiction";

/// Errors below this are no matter of method: round-off, or the width of a bracket.
inline constexpr double kSame = 1e-9;

/// Setting of a record: the engine of which its own is another build.
inline constexpr const char* kBuildOf = "build_of";

/// An engine in one of its configurations: a row of the matrix.
struct EngineRow {
  std::string engine, configuration;
  std::string build_of{};  ///< the engine of which this is another build; mostly empty
  std::string name() const { return engine + " · " + configuration; }
  bool is_ours() const { return engine == kOurEngine; }
  /// Neither ours nor another build of ours.
  bool is_others() const { return !is_ours() && build_of != kOurEngine; }
  bool operator==(const EngineRow&) const = default;
};

/// What an engine answered to a question.
struct EngineAnswer {
  bool asked = false;           ///< there is a record
  bool applicable = false;      ///< the engine has what the question needs
  std::optional<double> error;  ///< by the question's Answer; nothing where it broke
  double seconds = 0.0;         ///< CPU time of the case
  bool broke() const { return applicable && !error; }
};

/// One effort on a work-precision curve.
struct EffortPoint {
  EngineRow row;
  double error = 0.0, seconds = 0.0;
  std::size_t effort = 0;  ///< rung of the engine's ladder
};

/// The records that engine_records() made, by row and question.
class EngineAnswers {
 public:
  EngineAnswers(const std::vector<Question>& questions, const std::vector<Record>& made);

  const std::vector<Question>& questions() const { return questions_; }
  const std::vector<EngineRow>& rows() const { return rows_; }  ///< in the order of the records
  EngineAnswer of(const Question& question, const EngineRow& row) const;
  /// Of all rows and efforts; none for a question without a curve.
  std::vector<EffortPoint> points(const Question& question) const;
  /// The one with an error of at most `bound` for the least CPU time, ours or of the others; other
  /// builds of ours are neither.
  std::optional<EffortPoint> cheapest(const Question& question, double bound, bool ours) const;

 private:
  std::vector<Question> questions_;
  std::vector<Record> made_;
  std::vector<EngineRow> rows_;
};

}  // namespace stiction
