// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/engines/engine_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "reports/text/names.h"
#include "reports/text/number.h"
#include "validation/comparison/engines/answers.h"
#include "validation/comparison/engines/build_pairs.h"
#include "validation/comparison/engines/engine_matrix.h"
#include "validation/comparison/engines/holding.h"

namespace stiction {

namespace {

// Which of an engine's answers nobody's is closer than.
std::size_t closest(const EngineAnswers& answers, const EngineRow& row) {
  std::size_t count = 0;
  for (const Question& question : answers.questions()) {
    const EngineAnswer own = answers.of(question, row);
    if (!own.error || std::isnan(*own.error)) continue;
    const double bound = std::max(std::abs(*own.error), kSame);
    count +=
        std::none_of(answers.rows().begin(), answers.rows().end(), [&](const EngineRow& other) {
          const EngineAnswer theirs = answers.of(question, other);
          return theirs.error && std::max(std::abs(*theirs.error), kSame) < bound;
        });
  }
  return count;
}

// CPU time of the first question with a curve, s.
double seconds_of(const EngineAnswers& answers, const EngineRow& row) {
  for (const Question& question : answers.questions()) {
    if (!question.curve) continue;
    const EngineAnswer answer = answers.of(question, row);
    return answer.error ? answer.seconds : INFINITY;
  }
  return INFINITY;
}

std::size_t broken(const EngineAnswers& answers, const EngineRow& row) {
  return static_cast<std::size_t>(
      std::count_if(answers.questions().begin(), answers.questions().end(),
                    [&](const Question& one) { return answers.of(one, row).broke(); }));
}

std::string creep_text(const Holding& seen) {
  if (!seen.creep_asked) return "–";
  return std::isinf(seen.creep) ? "broke" : format_error(seen.creep);
}

std::string gives_text(const Holding& seen) {
  if (!seen.asked) return "–";
  if (seen.least <= -90.0 || seen.most >= 90.0) return "never";
  return format_error(std::max(std::abs(seen.least), std::abs(seen.most)));
}

std::string holding_text(const EngineAnswers& answers, const Screen& screen) {
  std::vector<std::pair<double, EngineRow>> hold;
  std::vector<std::string> others;
  bool asked = false;
  for (const EngineRow& row : answers.rows()) {
    const Holding seen = holding(answers, row);
    if (!seen.asked || !seen.creep_asked) continue;
    asked = true;
    if (seen.holds()) {
      hold.emplace_back(seconds_of(answers, row), row);
    } else {
      others.push_back(fmt::format("{} ({}; {})", row.name(), creep_text(seen), gives_text(seen)));
    }
  }
  if (!asked) return "";
  std::stable_sort(hold.begin(), hold.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string text =
      bold(fmt::format("{} of {} hold", hold.size(), hold.size() + others.size()), screen) +
      fmt::format(": creep at most {} m/s, give within {}° of the critical slope\n",
                  format_error(kCreeps), kGivesOff);
  Cells rows = {{"", "creep, m/s", "gives off, °", "CPU, ms", "closest in", "broke in"}};
  const std::size_t all = answers.questions().size();
  for (const auto& [seconds, row] : hold) {
    const Holding seen = holding(answers, row);
    rows.push_back({"  " + row.name(), creep_text(seen), gives_text(seen),
                    std::isinf(seconds) ? "–" : fmt::format("{:.3g}", 1e3 * seconds),
                    fmt::format("{} of {}", closest(answers, row), all),
                    fmt::format("{}", broken(answers, row))});
  }
  if (rows.size() > 1) text += plain_table(rows, {0}, screen.width);
  if (!others.empty()) {
    text += bullet("Not (creep, m/s; gives off, °): " + listed_names(others), screen.width, "  ");
  }
  return text + "\n";
}

const EngineRow* our_row(const EngineAnswers& answers) {
  for (const EngineRow& row : answers.rows()) {
    if (row.is_ours()) return &row;
  }
  return nullptr;
}

// "rolls dart · best 2e-6, ours 0.01": who answers a question best where ours is not the closest.
std::string closer_text(const EngineAnswers& answers, const EngineRow& our, std::size_t width) {
  std::vector<std::string> said;
  std::size_t asked = 0;
  for (const Question& question : answers.questions()) {
    const EngineAnswer own = answers.of(question, our);
    if (!own.applicable) continue;
    ++asked;
    double least = own.error ? std::abs(*own.error) : INFINITY;
    if (least <= kSame) continue;
    const EngineRow* who = nullptr;
    for (const EngineRow& row : answers.rows()) {
      const EngineAnswer other = answers.of(question, row);
      if (!row.is_others() || !other.error || !(std::abs(*other.error) < least)) continue;
      least = std::abs(*other.error);
      who = &row;
    }
    if (who == nullptr) continue;
    said.push_back(fmt::format("{}: {} {}, ours {}", question.id, who->name(),
                               short_error(question, *answers.of(question, *who).error),
                               own.error ? short_error(question, *own.error) : "broke"));
  }
  if (asked == 0) return "";
  std::string text = fmt::format("Closer than ours in {} of {} questions", said.size(), asked);
  for (std::size_t k = 0; k < said.size(); ++k) text += (k == 0 ? ": " : "; ") + said[k];
  return bullet(text + ".", width);
}

std::string cheaper_text(const EngineAnswers& answers, std::size_t width) {
  std::size_t cheaper = 0, all = 0;
  double most = 0.0;
  std::string where;
  for (const Question& question : answers.questions()) {
    if (!question.curve) continue;
    for (const double bound : kErrorBounds) {
      const auto theirs = answers.cheapest(question, bound, false);
      const auto ours = answers.cheapest(question, bound, true);
      if (!theirs && !ours) continue;
      ++all;
      if (!theirs || (ours && ours->seconds <= theirs->seconds)) continue;
      ++cheaper;
      const double ratio = ours ? ours->seconds / theirs->seconds : 0.0;
      if (ratio < most) continue;
      most = ratio;
      where = fmt::format("{} below {}: {} in {:.3g} ms, {}", question.id, format_error(bound),
                          theirs->row.name(), 1e3 * theirs->seconds,
                          ours ? fmt::format("ours {:.3g} times as much", ratio) : "ours never");
    }
  }
  if (all == 0) return "";
  return bullet(fmt::format("Cheaper than ours for {} of {} bounds of the error{}.", cheaper, all,
                            cheaper == 0 ? "" : ", most " + where),
                width);
}

std::string broken_text(const EngineAnswers& answers, std::size_t width) {
  std::vector<std::string> said;
  std::string again;
  for (const EngineRow& row : answers.rows()) {
    const std::size_t count = broken(answers, row);
    if (count == 0) continue;
    said.push_back(fmt::format("{} {}", row.name(), count));
    for (const Question& question : answers.questions()) {
      if (!again.empty() || !answers.of(question, row).broke()) continue;
      again = fmt::format("./stiction compare engines --engine '{}' --question {}", row.engine,
                          question.id);
    }
  }
  if (said.empty()) return "";
  return bullet("Broke: " + listed_names(said) + "; one again, with the reason in its record:",
                width) +
         "  " + again + "\n";
}

}  // namespace

std::string engine_summary(const EngineAnswers& answers, const Screen& screen) {
  std::string text = holding_text(answers, screen);
  const bool others = std::any_of(answers.rows().begin(), answers.rows().end(),
                                  [](const EngineRow& row) { return row.is_others(); });
  if (const EngineRow* const our = our_row(answers); our && others) {
    text += closer_text(answers, *our, screen.width) + cheaper_text(answers, screen.width);
  }
  const std::string builds = builds_text(answers, screen);
  if (!builds.empty()) text += (text.ends_with("\n\n") ? "" : "\n") + builds;
  return text + broken_text(answers, screen.width);
}

}  // namespace stiction
