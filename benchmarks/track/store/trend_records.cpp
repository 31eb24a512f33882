// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/store/trend_records.h"

namespace stiction::track {

std::vector<Record> trend_records(const std::vector<Trend>& trends,
                                  const Environment& environment) {
  std::vector<Record> records;
  for (const Trend& trend : trends) {
    const std::string name = "trend/" + trend.metric.subject;
    // Trends come by name, so those of a subject stand together.
    if (records.empty() || records.back().case_name != name) {
      Record& record = records.emplace_back();
      record.case_name = name;
      record.title = "History of " + trend.metric.subject;
      record.engine = "stiction";
      record.environment = environment;
      record.verdict = Verdict::kNotApplicable;
    }
    const Metric& metric = trend.metric;
    records.back().notes.push_back(
        metric.what + (higher_is_better(metric.kind) ? ": higher is better" : ": lower is better"));
    const bool in_ns = metric.kind == Kind::kTime && metric.unit == "s";
    Series series{
        .name = metric.what, .unit = in_ns ? "ns" : metric.unit, .x_name = "run", .x_unit = "1"};
    series.x.assign(trend.runs.begin(), trend.runs.end());
    for (const double value : trend.medians) series.y.push_back(in_ns ? value * 1e9 : value);
    records.back().series.push_back(std::move(series));
  }
  return records;
}

}  // namespace stiction::track
