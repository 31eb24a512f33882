// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/engines/answers.h"

#include <algorithm>

namespace stiction {

namespace {

EngineRow row_of(const Record& record) {
  const auto found = record.settings.find("configuration");
  return {record.engine, found == record.settings.end() ? "" : found->second};
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
    for (std::size_t k = 0; k < curve.x.size(); ++k) {
      points.push_back({row_of(record), curve.y[k], curve.x[k]});
    }
  }
  return points;
}

std::optional<EffortPoint> EngineAnswers::cheapest(const Question& question, double bound,
                                                   bool ours) const {
  std::optional<EffortPoint> best;
  for (const EffortPoint& point : points(question)) {
    if (!(point.error <= bound) || point.row.is_ours() != ours) continue;
    if (!best || point.seconds < best->seconds) best = point;
  }
  return best;
}

}  // namespace stiction
