// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/engines/answers.h"

#include <algorithm>
#include <set>

namespace stiction {

namespace {

EngineRow row_of(const Record& record) {
  const auto setting = [&](const char* name) {
    const auto found = record.settings.find(name);
    return found == record.settings.end() ? "" : found->second;
  };
  return {record.engine, setting("configuration"), setting(kBuildOf)};
}

// Efforts that have no point on the curve.
std::set<std::size_t> failed_efforts(const Record& record) {
  std::set<std::size_t> failed;
  for (const Failure& one : record.failures) {
    if (one.parameter != "effort") continue;
    for (const double effort : one.values) failed.insert(static_cast<std::size_t>(effort));
  }
  return failed;
}

bool is_of(const Record& record, const Question& question) {
  return record.case_name == "engines/" + question.id;
}

}  // namespace

EngineAnswers::EngineAnswers(const std::vector<Question>& questions,
                             const std::vector<Record>& made)
    : questions_(questions), made_(made) {
  for (const Record& record : made_) {
    if (std::find(rows_.begin(), rows_.end(), row_of(record)) == rows_.end()) {
      rows_.push_back(row_of(record));
    }
  }
}

EngineAnswer EngineAnswers::of(const Question& question, const EngineRow& row) const {
  EngineAnswer answer;
  for (const Record& record : made_) {
    if (!is_of(record, question) || row_of(record) != row) continue;
    answer.asked = true;
    answer.applicable = record.verdict != Verdict::kNotApplicable;
    for (const Figure& figure : record.figures) {
      if (figure.quantity == "error") answer.error = figure.value;
      if (figure.quantity == "CPU time") answer.seconds = figure.value;
    }
  }
  return answer;
}

std::vector<EffortPoint> EngineAnswers::points(const Question& question) const {
  std::vector<EffortPoint> points;
  for (const Record& record : made_) {
    if (!is_of(record, question) || record.series.empty()) continue;
    const Series& curve = record.series[0];
    const std::set<std::size_t> failed = failed_efforts(record);
    for (std::size_t k = 0, effort = 0; k < curve.x.size(); ++k, ++effort) {
      while (failed.count(effort) > 0) ++effort;
      points.push_back({row_of(record), curve.y[k], curve.x[k], effort});
    }
  }
  return points;
}

std::optional<EffortPoint> EngineAnswers::cheapest(const Question& question, double bound,
                                                   bool ours) const {
  std::optional<EffortPoint> best;
  for (const EffortPoint& point : points(question)) {
    const bool asked = ours ? point.row.is_ours() : point.row.is_others();
    if (!(point.error <= bound) || !asked) continue;
    if (!best || point.seconds < best->seconds) best = point;
  }
  return best;
}

}  // namespace stiction
