// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/work_precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/text/configuration_text.h"
#include "reports/text/family.h"
#include "reports/text/number.h"
#include "reports/text/text.h"

namespace stiction {

namespace {

// An error that is less than this many times its doubt is told as an upper bound.
constexpr double kTold = 2.0;

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
  point.setting = record.case_name.substr(std::min(family.size() + 1, record.case_name.size()));
  std::replace(point.setting.begin(), point.setting.end(), '/', ' ');
  point.method = configuration_name(record);
  const auto sweeps = record.settings.find("sweeps");
  if (sweeps != record.settings.end()) {
    point.method += ", " + counted(std::stoul(sweeps->second), "sweep");
  }
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
  return with_unit((bound ? "≤ " : "") + fmt::format("{:.1e}", point.error), point.unit);
}

std::vector<std::string> row_of(const std::string& question, const std::string& precisions,
                                const WorkPoint& point, bool reached) {
  return {question,
          precisions,
          reached ? point.method : "none; best: " + point.method,
          point.setting,
          fmt::format("{:.2g}", point.seconds),
          error_text(point)};
}

// "12 of 140 runs broke: 7 the time step … is above the stability limit …": reasons without their
// numbers are the same reason.
std::string broken_text(const std::vector<WorkPoint>& points) {
  const auto broke = std::count_if(points.begin(), points.end(),
                                   [](const WorkPoint& one) { return !one.broken.empty(); });
  return fmt::format("{} of {}", broke, points.size());
}

}  // namespace

std::vector<std::vector<WorkPoint>> work_points(const std::vector<Record>& records) {
  std::vector<std::vector<WorkPoint>> questions;
  for (const Record& record : records) {
    if (!record.case_name.starts_with(kWorkPrecision)) continue;
    if (record.verdict == Verdict::kNotApplicable) continue;
    WorkPoint point = point_of(record);
    const auto same =
        std::find_if(questions.begin(), questions.end(), [&](const std::vector<WorkPoint>& one) {
          return one.front().question == point.question;
        });
    if (same == questions.end()) {
      questions.push_back({std::move(point)});
    } else {
      same->push_back(std::move(point));
    }
  }
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

Cells cheapest_settings(const std::vector<Record>& records) {
  Cells rows{{"question", "error ≤", "cheapest", "setting", "CPU s/s", "error"}};
  for (const std::vector<WorkPoint>& points : work_points(records)) {
    const std::vector<WorkPoint> front = work_front(points);
    if (front.empty()) {
      rows.push_back({points.front().question, "", "every run broke", "", "", ""});
      continue;
    }
    const WorkPoint* last = nullptr;
    bool reached = true;
    std::string name = points.front().question;
    for (const double precision : kPrecisions) {
      if (!reached) break;
      const auto found = std::find_if(front.begin(), front.end(), [&](const WorkPoint& one) {
        return one.error <= precision;
      });
      reached = found != front.end();
      const WorkPoint& point = reached ? *found : front.back();
      const std::string words = fmt::format("1e{:.0f}", std::log10(precision));
      if (&point == last && reached) {
        rows.back()[1] += ", " + words;
        continue;
      }
      rows.push_back(row_of(name, words, point, reached));
      name.clear();
      last = &point;
    }
  }
  return rows.size() > 1 ? rows : Cells{};
}

std::string cheapest_settings_screen(const std::vector<Record>& records, const Screen& screen) {
  const Cells rows = cheapest_settings(records);
  if (rows.empty()) return "";
  std::string text = plain_table(rows, {0, 1, 2, 3}, screen.width);
  std::string broken;
  double spread = 1.0;
  for (const std::vector<WorkPoint>& points : work_points(records)) {
    broken += fmt::format("{}{} {}", broken.empty() ? "" : ", ", points.front().question,
                          broken_text(points));
    for (const WorkPoint& one : points) {
      if (one.broken.empty()) spread = std::max(spread, one.spread);
    }
  }
  text += bullet("Broke, and is on no front: " + broken + ".", screen.width);
  text += bullet(fmt::format("CPU s/s: of the thread, a simulated second; median of repetitions, "
                             "which differ by up to × {:.2g}.",
                             spread),
                 screen.width);
  return text;
}

std::string work_precision_markdown(const std::vector<Record>& records) {
  const auto table = [](const Cells& rows) {
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
  };
  const Cells cheapest = cheapest_settings(records);
  if (cheapest.empty()) return "";
  std::string text = "\n## The cheapest setting for an error\n\n" + table(cheapest);
  for (const std::vector<WorkPoint>& points : work_points(records)) {
    text += fmt::format("\n### Front of {} ({} runs broke)\n\n", points.front().question,
                        broken_text(points));
    Cells rows{{"method", "setting", "CPU s/s", "slowest ÷ fastest", "error"}};
    for (const WorkPoint& one : work_front(points)) {
      rows.push_back({one.method, one.setting, fmt::format("{:.2g}", one.seconds),
                      fmt::format("{:.2g}", one.spread), error_text(one)});
    }
    text += table(rows);
  }
  return text;
}

}  // namespace stiction
