// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/engines/engine_matrix.h"

#include <fmt/format.h>

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

std::string engine_matrix(const EngineAnswers& answers) {
  std::vector<std::vector<std::string>> table = {{"engine"}};
  for (const Question& question : answers.questions()) table[0].push_back(question.heading);
  table[0].push_back("CPU ms");
  for (const EngineRow& row : answers.rows()) {
    std::vector<std::string> cells = {row.name()};
    for (const Question& question : answers.questions()) {
      cells.push_back(cell(question, answers.of(question, row)));
    }
    cells.push_back(cost_cell(answers, row));
    table.push_back(std::move(cells));
  }
  return aligned_table(table, 1);
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
