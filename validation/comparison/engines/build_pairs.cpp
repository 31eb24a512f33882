// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/engines/build_pairs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/text/number.h"
#include "reports/text/text.h"
#include "validation/comparison/comparison_table.h"
#include "validation/comparison/engines/answers.h"
#include "validation/comparison/engines/engine_matrix.h"
#include "validation/comparison/figures.h"

namespace stiction {

namespace {

// An error this many times as large is a loss of digits, less is another rounding on the same way.
constexpr double kWorse = 2.0;

std::optional<double> magnitude(const std::optional<double>& error) {
  return error ? std::optional(std::abs(*error)) : std::nullopt;
}

const EffortPoint* point_of(const std::vector<EffortPoint>& points, const EngineRow& row,
                            std::size_t effort) {
  for (const EffortPoint& one : points) {
    if (one.row == row && one.effort == effort) return &one;
  }
  return nullptr;
}

void add_usual(const EngineAnswers& answers, std::size_t q, BuildPairs& pairs) {
  const EngineAnswer own = answers.of(answers.questions()[q], pairs.own);
  const EngineAnswer build = answers.of(answers.questions()[q], pairs.build);
  if (!own.applicable || !build.applicable) return;
  pairs.answers.push_back(
      {q, 0, magnitude(own.error), magnitude(build.error), own.seconds, build.seconds});
}

// The usual effort is a point of the curve too.
void add_curve(const EngineAnswers& answers, std::size_t q, BuildPairs& pairs) {
  const std::vector<EffortPoint> points = answers.points(answers.questions()[q]);
  std::size_t most = 0;
  for (const EffortPoint& one : points) {
    if (one.row == pairs.own || one.row == pairs.build) most = std::max(most, one.effort);
  }
  for (std::size_t effort = 1; effort <= most; ++effort) {
    const EffortPoint* const own = point_of(points, pairs.own, effort);
    const EffortPoint* const build = point_of(points, pairs.build, effort);
    AnswerPair pair{.question = q, .effort = effort};
    if (own) {
      pair.error = own->error;
      pair.seconds = own->seconds;
    }
    if (build) {
      pair.build_error = build->error;
      pair.build_seconds = build->seconds;
    }
    pairs.answers.push_back(pair);
  }
}

// What never came to what is asked for is off by any amount.
double judged(double error) {
  return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

bool is_worse(double error, double than) { return error > kWorse * std::max(than, kSame); }

// What all answers of a pair come to.
struct Tally {
  Spread speed;
  std::size_t timed = 0;
  std::size_t worse = 0, better = 0, broke = 0, own_broke = 0;
  const AnswerPair* worst = nullptr;  // the largest loss
  double loss = 1.0;
};

Tally tally_of(const BuildPairs& pairs) {
  Tally tally;
  std::vector<double> speeds;
  for (const AnswerPair& one : pairs.answers) {
    if (!std::isnan(one.speed())) speeds.push_back(one.speed());
    tally.broke += !one.build_error;
    tally.own_broke += !one.error;
    if (!one.error || !one.build_error) continue;
    const double own = judged(*one.error), build = judged(*one.build_error);
    tally.worse += is_worse(build, own);
    tally.better += is_worse(own, build);
    const double loss = build / std::max(own, kSame);
    if (!(loss > tally.loss) || std::isinf(loss)) continue;
    tally.loss = loss;
    tally.worst = &one;
  }
  tally.timed = speeds.size();
  tally.speed = spread_of(std::move(speeds));
  return tally;
}

std::string error_text(const Question& question, const std::optional<double>& error) {
  if (!error) return "broke";
  std::string text = short_error(question, *error);
  if (text.starts_with('+')) text.erase(0, 1);
  return text;
}

std::string ms_text(const std::optional<double>& error, double seconds) {
  if (!error) return "–";
  return seconds < 1.0 ? fmt::format("{:.3g}", 1e3 * seconds)
                       : fmt::format("{:.0f}", 1e3 * seconds);
}

std::string speed_text(double speed) {
  return std::isnan(speed) ? "–" : fmt::format("× {:.2f}", speed);
}

// The cells behind the question's.
std::vector<std::string> cells_of(const Question& question, const AnswerPair& one) {
  return {error_text(question, one.error), error_text(question, one.build_error),
          ms_text(one.error, one.seconds), ms_text(one.build_error, one.build_seconds),
          speed_text(one.speed())};
}

std::string sentence_of(const EngineAnswers& answers, const BuildPairs& pairs) {
  const Tally tally = tally_of(pairs);
  std::string text;
  if (tally.timed > 0) {
    text =
        fmt::format("speed × {:.2f} in the median of {} ({:.2f} to {:.2f}); ", tally.speed.median,
                    counted(tally.timed, "answer"), tally.speed.least, tally.speed.most);
  }
  text += fmt::format("error more than twice as large in {} of {}, less than half in {}",
                      tally.worse, counted(pairs.answers.size(), "answer"), tally.better);
  if (tally.worst) {
    const AnswerPair& worst = *tally.worst;
    const Question& question = answers.questions()[worst.question];
    text += fmt::format(", most in {}{} ({} for {})", question.id,
                        worst.effort > 0 ? fmt::format(", effort {}", worst.effort) : "",
                        error_text(question, worst.build_error), error_text(question, worst.error));
  }
  if (tally.broke + tally.own_broke > 0) {
    text += fmt::format("; broke in {}, {} in {}", tally.broke, pairs.own.engine, tally.own_broke);
  }
  return text + ".";
}

}  // namespace

double AnswerPair::speed() const {
  return error && build_error && build_seconds > 0.0 ? seconds / build_seconds : std::nan("");
}

std::vector<BuildPairs> build_pairs(const EngineAnswers& answers) {
  std::vector<BuildPairs> all;
  for (const EngineRow& build : answers.rows()) {
    if (build.build_of.empty()) continue;
    for (const EngineRow& own : answers.rows()) {
      if (own.engine != build.build_of || own.configuration != build.configuration) continue;
      BuildPairs pairs{.own = own, .build = build};
      for (std::size_t q = 0; q < answers.questions().size(); ++q) {
        add_usual(answers, q, pairs);
        if (answers.questions()[q].curve) add_curve(answers, q, pairs);
      }
      if (!pairs.answers.empty()) all.push_back(std::move(pairs));
    }
  }
  return all;
}

std::string builds_text(const EngineAnswers& answers, const Screen& screen) {
  std::string text;
  for (const BuildPairs& pairs : build_pairs(answers)) {
    Cells rows = {{"", "error", "of the build", "CPU, ms", "of the build", "speed"}};
    for (auto one = pairs.answers.begin(); one != pairs.answers.end(); ++one) {
      const Question& question = answers.questions()[one->question];
      if (!question.curve) continue;
      const auto next = one + 1;
      const bool last = next == pairs.answers.end() || next->question != one->question;
      if (one->effort > 0 && !last) continue;
      std::vector<std::string> row = {one->effort == 0 ? "  " + question.id
                                                       : fmt::format("  … effort {}", one->effort)};
      for (std::string& cell : cells_of(question, *one)) row.push_back(std::move(cell));
      rows.push_back(std::move(row));
    }
    text += bold(pairs.build.name(), screen) + " beside " + pairs.own.name() + ", step for step\n";
    if (rows.size() > 1) text += plain_table(rows, {0}, screen.width);
    text += bullet(sentence_of(answers, pairs), screen.width, "  ") + "\n";
  }
  return text;
}

std::string builds_tables(const EngineAnswers& answers) {
  std::string text;
  for (const BuildPairs& pairs : build_pairs(answers)) {
    std::vector<std::vector<std::string>> table = {
        {"question", "effort", "error, " + pairs.own.engine, pairs.build.engine,
         "CPU ms, " + pairs.own.engine, pairs.build.engine, "speed"}};
    for (const AnswerPair& one : pairs.answers) {
      const Question& question = answers.questions()[one.question];
      table.push_back({question.id, fmt::format("{}", one.effort)});
      for (std::string& cell : cells_of(question, one)) table.back().push_back(std::move(cell));
    }
    text += fmt::format("### {} beside {}\n\n{}\n", pairs.build.name(), pairs.own.name(),
                        aligned_table(table, 1));
  }
  return text;
}

std::vector<Figure> builds_figures(const EngineAnswers& answers) {
  std::vector<Figure> all;
  for (const BuildPairs& pairs : build_pairs(answers)) {
    const Spread speed = tally_of(pairs).speed;
    const std::string which =
        fmt::format("speed of {} over {}", pairs.build.name(), pairs.own.name());
    const char* const meaning = "CPU time of the same steps, over all answers and efforts: ";
    for (const auto& [words, value] :
         {std::pair{"median", speed.median}, {"least", speed.least}, {"most", speed.most}}) {
      if (!std::isnan(value)) {
        all.push_back({which + ", " + words, "1", std::string(meaning) + words, value});
      }
    }
  }
  return all;
}

std::vector<std::string> builds_findings(const EngineAnswers& answers) {
  std::vector<std::string> said;
  for (const BuildPairs& pairs : build_pairs(answers)) {
    said.push_back(fmt::format("{} beside {}, step for step: {}", pairs.build.name(),
                               pairs.own.name(), sentence_of(answers, pairs)));
  }
  return said;
}

}  // namespace stiction
