// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/engines/engine_matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/text/number.h"
#include "validation/comparison/comparison_table.h"

namespace stiction {

namespace {

std::string cell(const Question& question, const EngineAnswer& answer) {
  if (!answer.applicable) return "–";
  return answer.error ? short_error(question, *answer.error) : "broke";
}

// Milliseconds of CPU in the first question with a curve.
std::string cost_cell(const EngineAnswers& answers, const EngineRow& row) {
  for (const Question& question : answers.questions()) {
    if (!question.curve) continue;
    const EngineAnswer answer = answers.of(question, row);
    return answer.error ? fmt::format("{:.3g}", 1e3 * answer.seconds) : "–";
  }
  return "–";
}

// Of the widest cell.
std::size_t letters_of(const std::vector<std::string>& cells) {
  std::size_t most = 0;
  for (const std::string& one : cells) most = std::max(most, letters(one));
  return most;
}

std::string way(const std::optional<EffortPoint>& point) {
  return point ? fmt::format("{}, {:.3g} ms", point->row.name(), 1e3 * point->seconds) : "–";
}

}  // namespace

std::string short_error(const Question& question, double error) {
  if (std::isnan(error)) return "never";
  if (error == 0.0) return "0";
  if (question.answer == Answer::kCount) return fmt::format("{:.0f}", error);
  const bool tiny = std::abs(error) < 1e-3;
  std::string text = tiny ? fmt::format("{:+.0e}", error) : fmt::format("{:+.2g}", error);
  if (question.answer == Answer::kMagnitude) text = fmt::format("{:.1e}", error);
  const std::size_t exponent = text.find('e');
  if (exponent != std::string::npos && text.size() > exponent + 3 && text[exponent + 2] == '0') {
    text.erase(exponent + 2, 1);  // e-07 → e-7
  }
  return text;
}

std::string engine_matrix(const EngineAnswers& answers, std::size_t width) {
  // A column each: its heading, then a cell a row.
  std::vector<std::vector<std::string>> columns(answers.questions().size() + 1);
  std::vector<std::string> names = {"engine"};
  for (std::size_t q = 0; q < answers.questions().size(); ++q) {
    columns[q].push_back(answers.questions()[q].heading);
  }
  columns.back().push_back("CPU ms");
  for (const EngineRow& row : answers.rows()) {
    names.push_back(row.name());
    for (std::size_t q = 0; q < answers.questions().size(); ++q) {
      const Question& question = answers.questions()[q];
      columns[q].push_back(cell(question, answers.of(question, row)));
    }
    columns.back().push_back(cost_cell(answers, row));
  }
  std::string text;
  for (std::size_t next = 0; next < columns.size();) {
    std::size_t used = letters_of(names) + 4;
    std::vector<std::vector<std::string>> table;
    for (const std::string& name : names) table.push_back({name});
    do {
      used += letters_of(columns[next]) + 3;
      for (std::size_t r = 0; r < names.size(); ++r) table[r].push_back(columns[next][r]);
      ++next;
    } while (next < columns.size() &&
             (width == 0 || used + letters_of(columns[next]) + 3 <= width));
    text += (text.empty() ? "" : "\n") + aligned_table(table, 1);
  }
  return text;
}

std::string cheapest_ways(const EngineAnswers& answers) {
  std::vector<std::vector<std::string>> table = {
      {"question", "error below", "cheapest of the others", "ours"}};
  for (const Question& question : answers.questions()) {
    if (!question.curve) continue;
    for (const double bound : kErrorBounds) {
      const auto theirs = answers.cheapest(question, bound, false);
      const auto ours = answers.cheapest(question, bound, true);
      if (!theirs && !ours) continue;
      table.push_back({question.id, format_error(bound), way(theirs), way(ours)});
    }
  }
  return table.size() > 1 ? aligned_table(table, 4) : "";
}

}  // namespace stiction
