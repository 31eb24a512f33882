// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/sweep/boundary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "reports/formats/summary_table.h"
#include "reports/record/environment.h"
#include "reports/text/text.h"
#include "validation/judge/verdict.h"
#include "validation/user/quantity.h"

namespace stiction {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// One point beside the boundary.
struct Outcome {
  double along = 0.0, expected = 0.0;
  bool holds = false, must_hold = false;
  double distance() const { return along - expected; }
  bool wrong() const { return holds != must_hold; }
};

std::optional<Outcome> outcome_of(const Boundary& boundary, const std::vector<double>& values,
                                  const PointResult& result) {
  if (result.verdict == Verdict::kError || result.verdict == Verdict::kNotApplicable) return {};
  Outcome one;
  one.along = values[boundary.along];
  one.expected = boundary.axis ? values[*boundary.axis] : boundary.value;
  one.holds = result.holds;
  one.must_hold = (one.distance() < 0.0) != boundary.holds_above;
  if (one.distance() == 0.0) return {};
  return one;
}

// Over the expected value: the farthest along that holds, and the first that fails.
class Brackets {
 public:
  void add(const Outcome& one, bool holds_above) {
    const double sign = holds_above ? -1.0 : 1.0;
    auto& [holds, fails] = rows_.try_emplace(one.expected, kNan, kNan).first->second;
    double& end = one.holds ? holds : fails;
    const double further = sign * (one.along - end);
    if (std::isnan(end) || (one.holds ? further > 0.0 : further < 0.0)) end = one.along;
  }

  std::vector<Series> series(const Study& study, const Boundary& boundary) const {
    if (!boundary.axis || rows_.size() < 2) return {};
    const Axis& along = study.axes[boundary.along];
    const Axis& over = study.axes[*boundary.axis];
    const auto named = [&](const char* name) {
      return Series{
          along.vary + name, shown_unit(along.unit), over.vary, shown_unit(over.unit), {}, {}};
    };
    Series holds = named(", farthest that holds"), fails = named(", first that fails");
    for (const auto& [expected, ends] : rows_) {
      for (auto& [curve, y] : {std::pair(&holds, ends.first), std::pair(&fails, ends.second)}) {
        if (std::isnan(y)) continue;
        curve->x.push_back(expected);
        curve->y.push_back(y);
      }
    }
    std::vector<Series> all;
    for (Series* const curve : {&holds, &fails}) {
      if (!curve->x.empty()) all.push_back(std::move(*curve));
    }
    return all;
  }

 private:
  std::map<double, std::pair<double, double>> rows_{};  // holds, fails
};

std::string where_words(const Study& study, const std::vector<double>& values) {
  std::string words;
  for (std::size_t k = 0; k < values.size(); ++k) {
    words += fmt::format("{}{} = {:.6g}", k > 0 ? ", " : "", study.axes[k].vary, values[k]);
  }
  return words;
}

// Of the `count` points from `first` on.
Record record_of(const Study& study, const Points& points, const Results& results,
                 std::size_t first, std::size_t count) {
  const Boundary& boundary = *study.boundary;
  std::size_t outcomes = 0, wrong = 0, broke = 0;
  double farthest = 0.0;
  std::string where;
  bool judged = true;
  Brackets brackets;
  for (std::size_t point = first; point < first + count; ++point) {
    const PointResult& result = results[point];
    judged = judged && result.verdict != Verdict::kForInformation;
    broke += result.verdict == Verdict::kError;
    const std::vector<double> values = points.values(point);
    const std::optional<Outcome> one = outcome_of(boundary, values, result);
    if (!one) continue;
    ++outcomes;
    brackets.add(*one, boundary.holds_above);
    if (!one->wrong()) continue;
    ++wrong;
    if (std::abs(one->distance()) <= std::abs(farthest)) continue;
    farthest = one->distance();
    where = where_words(study, values) + (one->holds ? " holds" : " fails");
  }
  const StudyEngine& engine = points.engine(first);
  Record record;
  record.case_name = "sweep/" + study.name + "/boundary";
  if (!study.cases.empty()) record.case_name += "/" + points.job(first).which.name;
  record.title = study.title + ": where it turns";
  record.engine = engine.kind.name;
  record.configuration = called_configuration(engine.kind, "", engine.settings).name;
  record.settings = engine.settings;
  const double value = outcomes > 0 ? farthest : kNan;
  record.checks = {judged ? judge(boundary.claim, value) : for_information(boundary.claim, value)};
  record.checks.front().worst = where;
  record.notes = {fmt::format("{} of {} outcomes are on the wrong side", wrong, outcomes)};
  if (broke > 0) record.notes.push_back(fmt::format("{} points broke off", broke));
  record.series = brackets.series(study, boundary);
  for (std::size_t point = first; point < first + count; ++point) {
    record.cost.cpu_seconds += results[point].cpu_seconds;
  }
  record.simulations = count;
  record.environment = current_environment();
  record.verdict = verdict_of(record);
  return record;
}

}  // namespace

std::vector<Record> boundary_records(const Study& study, const Points& points,
                                     const Results& results) {
  if (!study.boundary) return {};
  std::vector<Record> records;
  const std::size_t count = study.designs();
  for (std::size_t first = 0; first < results.size(); first += count) {
    const auto begin = results.begin() + static_cast<std::ptrdiff_t>(first);
    if (std::all_of(begin, begin + static_cast<std::ptrdiff_t>(count),
                    [](const PointResult& one) { return one.known; })) {
      records.push_back(record_of(study, points, results, first, count));
    }
  }
  return records;
}

std::string boundary_screen(const std::vector<Record>& boundaries, const Screen& screen) {
  if (boundaries.empty()) return "";
  const Claim& claim = boundaries.front().checks.front().claim;
  std::string text = "\n" + bullet(claim.statement, screen.width, "");
  Cells rows = {{"", "farthest wrong outcome", "verdict", "where"}};
  for (const Record& one : boundaries) {
    const Judgement& check = one.checks.front();
    rows.push_back({one.configuration.empty() ? one.engine : one.engine + ", " + one.configuration,
                    fmt::format("{:.3g}", check.value), to_string(check.verdict),
                    check.worst.empty() ? "–" : check.worst});
  }
  return text + plain_table(rows, {0, 2, 3}, screen.width);
}

}  // namespace stiction
