// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/work_precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "reports/formats/summary_table.h"
#include "reports/text/configuration_text.h"
#include "reports/text/family.h"
#include "reports/text/number.h"

namespace stiction {

namespace {

// An error that is less than this many times its doubt is told as an upper bound.
constexpr double kTold = 2.0;

// Costs of one setting differ by as much from run to run even where its repetitions agree.
constexpr double kLeastNoise = 1.1;

double figure_of(const Record& record, const char* quantity) {
  for (const Figure& one : record.figures) {
    if (one.quantity == quantity) return one.value;
  }
  return std::nan("");
}

std::string unit_of(const Record& record, const char* quantity) {
  for (const Figure& one : record.figures) {
    if (one.quantity == quantity) return one.unit;
  }
  return "";
}

WorkPoint point_of(const Record& record) {
  const std::string family = family_name(record.case_name);
  WorkPoint point;
  point.question = family.substr(std::string(kWorkPrecision).size());
  std::istringstream rest(record.case_name.substr(family.size()));
  for (std::string part; std::getline(rest, part, '/');) {
    const std::size_t is = part.find('=');
    if (is == std::string::npos) continue;
    point.parameters.emplace_back(part.substr(0, is), part.substr(is + 1));
  }
  point.method = configuration_name(record);
  const auto sweeps = record.settings.find("sweeps");
  if (sweeps != record.settings.end()) point.method += " ×" + sweeps->second;
  point.seconds = figure_of(record, kWorkTime);
  point.error = figure_of(record, kErrorAtMost);
  point.doubt = figure_of(record, kErrorDoubt);
  point.spread = figure_of(record, kWorkSpread);
  point.unit = unit_of(record, kErrorAtMost);
  if (!record.failures.empty()) point.broken = record.failures.front().reason;
  if (record.verdict == Verdict::kError) point.broken = record.error;
  if (point.broken.empty() && !std::isfinite(point.error)) point.broken = "there is no answer";
  return point;
}

std::string error_text(const WorkPoint& point) {
  const bool bound = point.error < kTold * point.doubt;
  return (bound ? "≤ " : "") + fmt::format("{:.0e}", point.error);
}

std::string bound_text(double precision) { return fmt::format("1e{:.0f}", std::log10(precision)); }

std::string question_text(const WorkPoint& point) {
  return point.question + (point.unit == "1" ? "" : ", " + point.unit);
}

void add_parameters(std::vector<std::string>& row, const WorkPoint& point, bool names) {
  for (const auto& [name, value] : point.parameters) row.push_back(names ? name : value);
}

std::size_t broken_among(const std::vector<WorkPoint>& points) {
  return static_cast<std::size_t>(std::count_if(
      points.begin(), points.end(), [](const WorkPoint& one) { return !one.broken.empty(); }));
}

std::string markdown_table(const Cells& rows) {
  std::string text;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    text += "|";
    for (const std::string& cell : rows[r]) text += " " + cell + " |";
    text += "\n";
    if (r > 0) continue;
    text += "|";
    for (std::size_t c = 0; c < rows[r].size(); ++c) text += " --- |";
    text += "\n";
  }
  return text;
}

}  // namespace

std::vector<std::vector<WorkPoint>> work_points(const std::vector<Record>& records) {
  std::vector<std::vector<WorkPoint>> questions;
  for (const Record& record : records) {
    if (!record.case_name.starts_with(kWorkPrecision)) continue;
    if (record.verdict == Verdict::kNotApplicable) continue;
    WorkPoint point = point_of(record);
    const auto same = std::find_if(
        questions.begin(), questions.end(),
        [&](const std::vector<WorkPoint>& one) { return one.front().question == point.question; });
    if (same == questions.end()) {
      questions.push_back({std::move(point)});
    } else {
      same->push_back(std::move(point));
    }
  }
  std::sort(questions.begin(), questions.end(),
            [](const auto& a, const auto& b) { return a.front().question < b.front().question; });
  return questions;
}

std::vector<WorkPoint> work_front(const std::vector<WorkPoint>& points) {
  std::vector<WorkPoint> sorted;
  for (const WorkPoint& one : points) {
    if (one.broken.empty()) sorted.push_back(one);
  }
  std::stable_sort(sorted.begin(), sorted.end(), [](const WorkPoint& a, const WorkPoint& b) {
    return std::pair(a.seconds, a.error) < std::pair(b.seconds, b.error);
  });
  std::vector<WorkPoint> front;
  for (WorkPoint& one : sorted) {
    if (front.empty() || one.error < front.back().error) front.push_back(std::move(one));
  }
  return front;
}

std::optional<WorkPoint> cheapest_setting(const std::vector<WorkPoint>& points, double precision) {
  for (const WorkPoint& one : work_front(points)) {
    if (one.error <= precision) return one;
  }
  return std::nullopt;
}

std::vector<std::string> as_cheap(const std::vector<WorkPoint>& points, const WorkPoint& chosen,
                                  double precision) {
  std::set<std::string> methods;
  for (const WorkPoint& one : points) {
    if (!one.broken.empty() || !(one.error <= precision) || one.method == chosen.method) continue;
    const double noise = std::max({kLeastNoise, one.spread, chosen.spread});
    if (one.seconds <= noise * chosen.seconds) methods.insert(one.method);
  }
  return {methods.begin(), methods.end()};
}

std::optional<WorkPoint> most_precise_setting(const std::vector<WorkPoint>& points) {
  const std::vector<WorkPoint> front = work_front(points);
  if (front.empty()) return std::nullopt;
  return cheapest_setting(front, front.back().error + front.back().doubt);
}

Cells cheapest_settings(const std::vector<Record>& records, bool ties) {
  const std::vector<std::vector<WorkPoint>> questions = work_points(records);
  if (questions.empty()) return {};
  std::vector<std::string> heading{"question", "error ≤", "method"};
  add_parameters(heading, questions.front().front(), true);
  heading.insert(heading.end(), {"CPU s/s", "error"});
  if (ties) heading.push_back("as cheap");
  Cells rows{heading};
  for (const std::vector<WorkPoint>& points : questions) {
    const std::optional<WorkPoint> best = most_precise_setting(points);
    if (!best) {
      rows.push_back({question_text(points.front()), "", "all broke"});
      rows.back().resize(heading.size());
      continue;
    }
    std::optional<WorkPoint> last;
    for (const double precision : kPrecisions) {
      const std::optional<WorkPoint> found = cheapest_setting(points, precision);
      const WorkPoint& point = found ? *found : *best;
      const std::string bound = bound_text(precision);
      if (found && last && found->method == last->method && found->parameters == last->parameters) {
        std::string& bounds = rows.back()[1];
        bounds = bounds.substr(0, bounds.find("…")) + "…" + bound;
        continue;
      }
      rows.push_back({precision == kPrecisions.front() ? question_text(point) : "",
                      bound + (found ? "" : " none, best"), point.method});
      add_parameters(rows.back(), point, false);
      rows.back().push_back(fmt::format("{:.2g}", point.seconds));
      rows.back().push_back(error_text(point));
      if (ties) {
        const double met = found ? precision : point.error;
        rows.back().push_back(fmt::format("{}", fmt::join(as_cheap(points, point, met), "; ")));
      }
      if (!found) break;  // none for a smaller error either
      last = found;
    }
  }
  return rows;
}

std::string cheapest_settings_screen(const std::vector<Record>& records, const Screen& screen) {
  const Cells rows = cheapest_settings(records);
  if (rows.empty()) return "";
  std::string text = plain_table(rows, {0, 1, 2}, screen.width, screen.width < kRoomy ? 1 : 2);
  std::string broken;
  double spread = 1.0;
  for (const std::vector<WorkPoint>& points : work_points(records)) {
    broken += fmt::format("{}{} {} of {}", broken.empty() ? "" : ", ", points.front().question,
                          broken_among(points), points.size());
    for (const WorkPoint& one : points) {
      if (one.broken.empty() && one.spread > spread) spread = one.spread;
    }
  }
  text += bullet("Broke, and on no front: " + broken + ".", screen.width);
  text += bullet(fmt::format("CPU s/s: CPU time of the thread for a simulated second, median of "
                             "repetitions that differ by up to × {:.2g}. Errors are relative where "
                             "a question has no unit; ≤: not told from none. ×8: sweeps.",
                             spread),
                 screen.width);
  return text;
}

std::string cheapest_settings_markdown(const std::vector<Record>& records) {
  return markdown_table(cheapest_settings(records, true));
}

std::string work_precision_markdown(const std::vector<Record>& records) {
  const std::vector<std::vector<WorkPoint>> questions = work_points(records);
  if (questions.empty()) return "";
  std::string text =
      "\n## The cheapest setting for an error\n\n" + cheapest_settings_markdown(records);
  for (const std::vector<WorkPoint>& points : questions) {
    text += fmt::format("\n### Front of {}: {} of {} runs broke\n\n", points.front().question,
                        broken_among(points), points.size());
    std::vector<std::string> heading{"method"};
    add_parameters(heading, points.front(), true);
    heading.insert(heading.end(), {"CPU s/s", "slowest ÷ fastest", "error", "of which uncertain"});
    Cells rows{heading};
    for (const WorkPoint& one : work_front(points)) {
      rows.push_back({one.method});
      add_parameters(rows.back(), one, false);
      rows.back().push_back(fmt::format("{:.2g}", one.seconds));
      rows.back().push_back(fmt::format("{:.2g}", one.spread));
      rows.back().push_back(with_unit(fmt::format("{:.2g}", one.error), one.unit));
      rows.back().push_back(fmt::format("{:.1g}", one.doubt));
    }
    text += markdown_table(rows);
  }
  return text;
}

}  // namespace stiction
