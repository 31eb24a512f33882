// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/engines/engine_matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "reports/text/number.h"
#include "validation/comparison/comparison_table.h"

namespace stiction {

namespace {

constexpr const char* kOurs = "stiction";

// Bounds of the cheapest ways; below them no engine's own scheme of first order is told from another.
constexpr double kBounds[] = {1e-2, 1e-4, 1e-6};

struct Row {
  std::string engine, configuration;
  std::string name() const { return engine + " · " + configuration; }
  bool operator==(const Row&) const = default;
};

Row row_of(const Record& record) {
  const auto found = record.settings.find("configuration");
  return {record.engine, found == record.settings.end() ? "" : found->second};
}

std::vector<Row> rows_of(const std::vector<Record>& made) {
  std::vector<Row> rows;
  for (const Record& record : made) {
    if (std::find(rows.begin(), rows.end(), row_of(record)) == rows.end()) {
      rows.push_back(row_of(record));
    }
  }
  return rows;
}

const Record* find(const std::vector<Record>& made, const Question& question, const Row& row) {
  for (const Record& record : made) {
    if (record.case_name == "engines/" + question.id && row_of(record) == row) return &record;
  }
  return nullptr;
}

std::optional<double> figure_of(const Record* record, const char* quantity) {
  if (!record) return std::nullopt;
  for (const Figure& figure : record->figures) {
    if (figure.quantity == quantity) return figure.value;
  }
  return std::nullopt;
}

std::string cell(const Question& question, const Record* record) {
  if (!record || record->verdict == Verdict::kNotApplicable) return "–";
  const std::optional<double> error = figure_of(record, "error");
  return error ? short_error(question, *error) : "broke";
}

// Milliseconds of CPU in the first curve question that was asked.
std::string cost_cell(const std::vector<Question>& questions, const std::vector<Record>& made,
                      const Row& row) {
  for (const Question& question : questions) {
    if (!question.curve) continue;
    const std::optional<double> seconds = figure_of(find(made, question, row), "CPU time");
    return seconds ? fmt::format("{:.3g}", 1e3 * *seconds) : "–";
  }
  return "–";
}

// Errors and CPU times of all efforts, ours or theirs.
struct Point {
  Row row;
  double error, seconds;
};

std::vector<Point> points_of(const std::vector<Record>& made, const Question& question) {
  std::vector<Point> points;
  for (const Record& record : made) {
    if (record.case_name != "engines/" + question.id || record.series.empty()) continue;
    const Series& curve = record.series[0];
    for (std::size_t k = 0; k < curve.x.size(); ++k) {
      points.push_back({row_of(record), curve.y[k], curve.x[k]});
    }
  }
  return points;
}

const Point* cheapest(const std::vector<Point>& points, double bound, bool ours) {
  const Point* best = nullptr;
  for (const Point& point : points) {
    if (!(point.error <= bound) || (point.row.engine == kOurs) != ours) continue;
    if (!best || point.seconds < best->seconds) best = &point;
  }
  return best;
}

std::string way(const Point* point) {
  if (!point) return "–";
  return fmt::format("{}, {:.3g} ms", point->row.name(), 1e3 * point->seconds);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace

std::string short_error(const Question& question, double error) {
  if (std::isnan(error)) return "never";
  if (error == 0.0) return "0";
  const bool tiny = std::abs(error) < 1e-3;
  std::string text = tiny ? fmt::format("{:+.0e}", error) : fmt::format("{:+.2g}", error);
  if (question.answer == Answer::kMagnitude) text = fmt::format("{:.1e}", error);
  const std::size_t exponent = text.find('e');
  if (exponent != std::string::npos && text.size() > exponent + 3 && text[exponent + 2] == '0') {
    text.erase(exponent + 2, 1);  // e-07 → e-7
  }
  return text;
}

std::string engine_matrix(const std::vector<Question>& questions, const std::vector<Record>& made) {
  std::vector<std::vector<std::string>> table = {{"engine"}};
  for (const Question& question : questions) table[0].push_back(question.heading);
  table[0].push_back("CPU ms");
  for (const Row& row : rows_of(made)) {
    std::vector<std::string> cells = {row.name()};
    for (const Question& question : questions) {
      cells.push_back(cell(question, find(made, question, row)));
    }
    cells.push_back(cost_cell(questions, made, row));
    table.push_back(std::move(cells));
  }
  return aligned_table(table, 1);
}

std::string cheapest_ways(const std::vector<Question>& questions, const std::vector<Record>& made) {
  std::vector<std::vector<std::string>> table = {
      {"question", "error below", "cheapest of the others", "ours"}};
  for (const Question& question : questions) {
    if (!question.curve) continue;
    const std::vector<Point> points = points_of(made, question);
    for (const double bound : kBounds) {
      const Point* const theirs = cheapest(points, bound, false);
      const Point* const ours = cheapest(points, bound, true);
      if (!theirs && !ours) continue;
      table.push_back({question.id, format_error(bound), way(theirs), way(ours)});
    }
  }
  return table.size() > 1 ? aligned_table(table, 4) : "";
}

std::vector<std::string> engine_findings(const std::vector<Question>& questions,
                                         const std::vector<Record>& made) {
  std::vector<std::string> said;
  const std::vector<Row> rows = rows_of(made);
  // First where others are better than ours, or as good for less.
  for (const Question& question : questions) {
    const Row* ours = nullptr;
    for (const Row& row : rows) {
      if (row.engine == kOurs && !ours) ours = &row;
    }
    if (!ours) break;
    const Record* const own = find(made, question, *ours);
    const std::optional<double> error = figure_of(own, "error");
    const std::optional<double> seconds = figure_of(own, "CPU time");
    if (!error || !seconds) continue;
    std::vector<std::string> better, cheaper;
    for (const Row& row : rows) {
      if (row.engine == kOurs) continue;
      const Record* const other = find(made, question, row);
      const std::optional<double> theirs = figure_of(other, "error");
      if (!theirs || std::isnan(*theirs)) continue;
      if (std::abs(*theirs) < std::abs(*error)) {
        better.push_back(fmt::format("{} ({})", row.name(), short_error(question, *theirs)));
      } else if (std::abs(*theirs) == std::abs(*error) &&
                 figure_of(other, "CPU time").value_or(*seconds) < *seconds) {
        cheaper.push_back(fmt::format("{} ({:.3g} ms against {:.3g} ms)", row.name(),
                                      1e3 * *figure_of(other, "CPU time"), 1e3 * *seconds));
      }
    }
    if (!better.empty()) {
      said.push_back(fmt::format("{}: closer to the right answer than ours ({}): {}", question.id,
                                 short_error(question, *error), joined(better)));
    }
    if (!cheaper.empty()) {
      said.push_back(
          fmt::format("{}: as close as ours for less CPU time: {}", question.id, joined(cheaper)));
    }
  }
  for (const Question& question : questions) {
    if (!question.curve) continue;
    const std::vector<Point> points = points_of(made, question);
    for (const double bound : kBounds) {
      const Point* const theirs = cheapest(points, bound, false);
      const Point* const ours = cheapest(points, bound, true);
      if (!theirs || !ours || theirs->seconds >= ours->seconds) continue;
      said.push_back(fmt::format(
          "{}: an error below {} costs {:.3g} ms with {}, {:.2g} times as much with ours",
          question.id, format_error(bound), 1e3 * theirs->seconds, theirs->row.name(),
          ours->seconds / theirs->seconds));
    }
  }
  // Who holds, and whose friction has directions.
  std::vector<std::string> hold, directed, broke;
  for (const Row& row : rows) {
    double creep = 0.0, least = std::numeric_limits<double>::infinity(), most = -least;
    bool asked = false, failed = false;
    for (const Question& question : questions) {
      const Record* const record = find(made, question, row);
      const std::optional<double> error = figure_of(record, "error");
      if (record && !error && record->verdict != Verdict::kNotApplicable) failed = true;
      if (!error) continue;
      if (question.quantity == "creep") creep = std::max(creep, std::abs(*error));
      if (question.quantity == "slope that gives") {
        asked = true;
        least = std::min(least, std::isnan(*error) ? -90.0 : *error);
        most = std::max(most, std::isnan(*error) ? 90.0 : *error);
      }
    }
    if (asked && creep <= 1e-9 && least > -0.01 && most < 0.01) hold.push_back(row.name());
    if (asked && most - least > 0.1) {
      directed.push_back(fmt::format("{} ({:+.2g}° to {:+.2g}°)", row.name(), least, most));
    }
    if (failed) broke.push_back(row.name());
  }
  said.push_back(
      fmt::format("Hold up to 0.01° below the critical slope and creep below 1e-9 m/s, in "
                  "each direction asked: {}",
                  hold.empty() ? "none" : joined(hold)));
  if (!directed.empty()) {
    said.push_back("The slope that gives depends on its direction: " + joined(directed));
  }
  if (!broke.empty()) said.push_back("Broke on a question: " + joined(broke));
  return said;
}

}  // namespace stiction
