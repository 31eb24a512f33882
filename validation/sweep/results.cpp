// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/sweep/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "reports/formats/csv.h"
#include "reports/text/text.h"
#include "validation/user/quantity.h"

namespace stiction {

namespace {

std::string axis_words(const Axis& axis) {
  return axis.unit == "1" ? axis.vary : fmt::format("{} [{}]", axis.vary, shown_unit(axis.unit));
}

// How a point looks in a diagram.
char sign_of(const PointResult& result) {
  if (!result.known) return '?';
  switch (result.verdict) {
    case Verdict::kPass:
      return '#';
    case Verdict::kError:
      return '!';
    case Verdict::kNotApplicable:
      return ' ';
    case Verdict::kForInformation:  // of a configuration that runs for contrast
      return result.holds ? 'o' : '-';
    default:
      return '.';
  }
}

struct Counts {
  std::size_t hold = 0, fail = 0, unjudged = 0, broke = 0, lacking = 0, missing = 0;
  double cpu_seconds = 0.0;
};

// Of the `count` points from `first` on.
Counts counted(const Results& results, std::size_t first, std::size_t count) {
  Counts counts;
  for (std::size_t k = first; k < first + count; ++k) {
    const PointResult& one = results[k];
    counts.cpu_seconds += one.cpu_seconds;
    switch (sign_of(one)) {
      case '#':
        ++counts.hold;
        break;
      case '!':
        ++counts.broke;
        break;
      case 'o':
      case '-':
        ++counts.unjudged;
        break;
      case ' ':
        ++counts.lacking;
        break;
      case '?':
        ++counts.missing;
        break;
      default:
        ++counts.fail;
    }
  }
  return counts;
}

// Two axes of a grid with more than one value each, the first across; none where they are not two.
std::optional<std::pair<std::size_t, std::size_t>> plane_of(const Study& study) {
  if (study.samples) return std::nullopt;
  std::vector<std::size_t> wide;
  for (std::size_t k = 0; k < study.axes.size(); ++k) {
    if (study.axes[k].values.size() > 1) wide.push_back(k);
  }
  if (wide.size() != 2) return std::nullopt;
  return std::pair(wide[0], wide[1]);
}

// Up the second axis, across the first: the designs from `first` on, all other axes having one value.
std::string diagram(const Study& study, const Results& results, std::size_t first,
                    const Screen& screen) {
  const auto plane = plane_of(study);
  if (!plane) return "";
  const Axis& across = study.axes[plane->first];
  const Axis& up = study.axes[plane->second];
  std::vector<std::string> labels;
  std::size_t width = 0;
  for (const double value : up.values) {
    labels.push_back(fmt::format("{:.4g}", value));
    width = std::max(width, labels.back().size());
  }
  if (across.values.size() + width + 4 > screen.width) return "";
  std::string text = fmt::format("  {} up, {} across\n", axis_words(up), axis_words(across));
  for (std::size_t row = up.values.size(); row-- > 0;) {
    text += fmt::format("  {:>{}} ", labels[row], width);
    for (std::size_t column = 0; column < across.values.size(); ++column) {
      text += sign_of(results[first + column * up.values.size() + row]);
    }
    text += '\n';
  }
  const std::string left = fmt::format("{:.4g}", across.values.front());
  const std::string right = fmt::format("{:.4g}", across.values.back());
  const std::size_t gap = std::max<std::size_t>(
      1, across.values.size() - std::min(across.values.size(), left.size() + right.size()));
  return text + fmt::format("  {:>{}} {}{:{}}{}\n", "", width, left, "", gap, right);
}

}  // namespace

PointResult result_of(const Record& record) {
  PointResult result{true, record.verdict, !record.checks.empty(), record.cost.cpu_seconds, {}};
  for (const Judgement& check : record.checks) {
    result.values.push_back(check.value);
    result.holds = result.holds && check.of_tolerance <= 1.0;
  }
  return result;
}

std::string points_csv(const Study& study, const Points& points,
                       const std::vector<std::size_t>& told, const Results& results) {
  std::size_t checks = 0;
  for (const PointResult& one : results) checks = std::max(checks, one.values.size());
  std::vector<std::string> head = {"point", "case", "engine", "configuration"};
  for (const Axis& axis : study.axes) head.push_back(csv_words(axis_words(axis)));
  head.insert(head.end(), {"verdict", "cpu_seconds"});
  for (std::size_t k = 1; k <= checks; ++k) head.push_back(fmt::format("check {}", k));
  std::string text = csv_row(head);
  for (const std::size_t point : told) {
    const PointResult& one = results[point];
    std::vector<std::string> cells = {points.hash(point), csv_words(points.name(point)),
                                      csv_words(points.engine(point).kind.name),
                                      csv_words(points.engine(point).configuration)};
    for (const double value : points.values(point)) cells.push_back(fmt::format("{}", value));
    cells.push_back(one.known ? std::string(to_string(one.verdict)) : "");
    cells.push_back(one.known ? fmt::format("{:.6g}", one.cpu_seconds) : "");
    for (std::size_t k = 0; k < checks; ++k) {
      cells.push_back(k < one.values.size() ? fmt::format("{}", one.values[k]) : "");
    }
    text += csv_row(cells);
  }
  return text;
}

std::string results_screen(const Study& study, const Results& results, const Screen& screen) {
  const std::size_t designs = study.designs();
  const std::size_t cases = std::max<std::size_t>(1, study.cases.size());
  // What may be all zero has no column then.
  const Counts all = counted(results, 0, results.size());
  const std::vector<std::pair<std::string, std::size_t Counts::*>> columns = [&] {
    std::vector<std::pair<std::string, std::size_t Counts::*>> out = {{"hold", &Counts::hold},
                                                                      {"fail", &Counts::fail}};
    if (all.unjudged > 0) out.emplace_back("not judged", &Counts::unjudged);
    if (all.broke > 0) out.emplace_back("broke off", &Counts::broke);
    if (all.lacking > 0) out.emplace_back("not applicable", &Counts::lacking);
    if (all.missing > 0) out.emplace_back("missing", &Counts::missing);
    return out;
  }();
  Cells rows = {{"", "points"}};
  for (const auto& [name, count] : columns) rows.front().push_back(name);
  rows.front().push_back("CPU s");
  std::string diagrams;
  for (std::size_t e = 0; e < study.engines.size(); ++e) {
    for (std::size_t c = 0; c < cases; ++c) {
      const std::size_t first = (e * cases + c) * designs;
      const Counts counts = counted(results, first, designs);
      std::string words = name_of(study.engines[e]);
      if (!study.cases.empty()) words += ": " + study.cases[c].name;
      std::vector<std::string> row = {words, std::to_string(designs)};
      for (const auto& [name, count] : columns) row.push_back(std::to_string(counts.*count));
      row.push_back(fmt::format("{:.3g}", counts.cpu_seconds));
      rows.push_back(std::move(row));
      const std::string drawn = diagram(study, results, first, screen);
      if (!drawn.empty()) diagrams += "\n" + bold(one_line(words), screen) + "\n" + drawn;
    }
  }
  std::string text = plain_table(rows, {0}, screen.width);
  if (diagrams.empty()) return text;
  return text + diagrams +
         "\n  # holds   . fails   o, - the same, not judged   ! broke off   ? missing   (blank: "
         "not applicable)\n";
}

}  // namespace stiction
