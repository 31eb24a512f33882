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
  // A grid's steps are decimal numbers: 0.4 − 0.3 is 0.1.
  double distance() const { return std::stod(fmt::format("{:.12g}", along - expected)); }
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
    if (!boundary.axis || rows_.size() < 2 || study.samples) return {};
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

// The points of an engine.
struct Seen {
  std::size_t inside = 0, beyond = 0;  // outcomes where it must hold, and where it must fail
  std::size_t wrong = 0, broke = 0, lacking = 0;
  double farthest = 0.0, cpu_seconds = 0.0;
  std::string where;
  bool judged = true;
  Brackets brackets;

  void add(const Study& study, const std::vector<double>& values, const PointResult& result) {
    judged = judged && result.verdict != Verdict::kForInformation;
    cpu_seconds += result.cpu_seconds;
    broke += result.verdict == Verdict::kError;
    lacking += result.verdict == Verdict::kNotApplicable;
    const std::optional<Outcome> one = outcome_of(*study.boundary, values, result);
    if (!one) return;
    ++(one->must_hold ? inside : beyond);
    brackets.add(*one, study.boundary->holds_above);
    if (!one->wrong()) return;
    ++wrong;
    if (std::abs(one->distance()) <= std::abs(farthest)) return;
    farthest = one->distance();
    where = where_words(study, values) + (one->holds ? " holds" : " fails");
  }

  // Why they show no boundary; empty where they do.
  std::string gap() const {
    if (broke > 0)
      return fmt::format("{} {} off", broke, broke == 1 ? "point broke" : "points broke");
    if (inside == 0) return "no point lies where it must hold";
    if (beyond == 0) return "no point lies where it must fail";
    return "";
  }
};

// Of the `count` points from `first` on.
Record record_of(const Study& study, const Points& points, const Results& results,
                 std::size_t first, std::size_t count) {
  const Boundary& boundary = *study.boundary;
  Seen seen;
  for (std::size_t point = first; point < first + count; ++point) {
    seen.add(study, points.values(point), results[point]);
  }
  const StudyEngine& engine = points.engine(first);
  Record record;
  record.case_name = "sweep/" + study.name + "/boundary";
  if (!study.cases.empty()) record.case_name += "/" + points.job(first).which.name;
  record.title = study.title + ": where it turns";
  record.engine = engine.kind.name;
  record.configuration = called_configuration(engine.kind, "", engine.settings).name;
  record.settings = engine.settings;
  if (seen.lacking < count) {
    const std::string gap = seen.gap();
    const double value = gap.empty() ? seen.farthest : kNan;
    record.checks = {seen.judged ? judge(boundary.claim, value)
                                 : for_information(boundary.claim, value)};
    record.checks.front().worst = gap.empty() ? seen.where : gap;
  }
  record.notes = {fmt::format("{} of {} outcomes are on the wrong side", seen.wrong,
                              seen.inside + seen.beyond)};
  record.series = seen.brackets.series(study, boundary);
  record.cost.cpu_seconds = seen.cpu_seconds;
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
  std::string text;
  for (const Record& one : boundaries) {
    if (text.empty() && !one.checks.empty()) {
      text = "\n" + bullet(one.checks.front().claim.statement, screen.width, "");
    }
  }
  Cells rows = {{"", "farthest wrong outcome", "verdict", "where"}};
  for (const Record& one : boundaries) {
    if (one.checks.empty()) continue;  // not applicable
    const Judgement& check = one.checks.front();
    rows.push_back({one.configuration.empty() ? one.engine : one.engine + ", " + one.configuration,
                    std::isnan(check.value) ? "–" : fmt::format("{:.3g}", check.value),
                    to_string(check.verdict), check.worst.empty() ? "–" : check.worst});
  }
  return text + plain_table(rows, {0, 2, 3}, screen.width);
}

}  // namespace stiction
