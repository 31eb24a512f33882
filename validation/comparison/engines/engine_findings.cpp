// SPDX-License-Identifier: GPL-3.0-or-later
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

constexpr double kDirected = 0.1;  // °, between directions

constexpr std::size_t kTold = 4;  // of those that are closer, the closest

using Sentences = std::vector<std::string>;

const EngineRow* our_row(const EngineAnswers& answers) {
  for (const EngineRow& row : answers.rows()) {
    if (row.is_ours()) return &row;
  }
  return nullptr;
}

// "creep-30: closer to the right answer than ours (4e-9): bullet · best (2e-10)".
Sentences closer_than_ours(const EngineAnswers& answers, const EngineRow& our) {
  Sentences said;
  for (const Question& question : answers.questions()) {
    const EngineAnswer own = answers.of(question, our);
    if (!own.applicable) continue;
    const double error = own.error ? std::abs(*own.error) : INFINITY;
    if (error <= kSame) continue;
    std::vector<std::pair<double, std::string>> closer;
    for (const EngineRow& row : answers.rows()) {
      const EngineAnswer other = answers.of(question, row);
      if (!row.is_others() || !other.error || !(std::abs(*other.error) < error)) continue;
      closer.emplace_back(std::abs(*other.error),
                          fmt::format("{} ({})", row.name(), short_error(question, *other.error)));
    }
    if (closer.empty()) continue;
    std::sort(closer.begin(), closer.end());
    Sentences first;
    for (std::size_t k = 0; k < std::min(kTold, closer.size()); ++k)
      first.push_back(closer[k].second);
    said.push_back(fmt::format(
        "{}: closer to the right answer than ours ({}): {}{}", question.id,
        own.error ? short_error(question, *own.error) : "broke", listed_names(first),
        closer.size() > kTold ? fmt::format(" and {} more", closer.size() - kTold) : ""));
  }
  return said;
}

// "stops: an error below 0.01 costs 0.34 ms with bullet · default, a 66th of ours".
Sentences cheaper_than_ours(const EngineAnswers& answers) {
  Sentences said;
  for (const Question& question : answers.questions()) {
    Sentences bounds;
    for (const double bound : kErrorBounds) {
      const auto theirs = answers.cheapest(question, bound, false);
      const auto ours = answers.cheapest(question, bound, true);
      if (!theirs || (ours && ours->seconds <= theirs->seconds)) continue;
      bounds.push_back(fmt::format(
          "below {} {:.3g} ms with {} ({})", format_error(bound), 1e3 * theirs->seconds,
          theirs->row.name(),
          ours ? fmt::format("ours {:.2g} times as much", ours->seconds / theirs->seconds)
               : "ours never gets there"));
    }
    if (!bounds.empty()) {
      said.push_back(fmt::format("{}: an error costs less with others: {}", question.id,
                                 listed_names(bounds)));
    }
  }
  return said;
}

Sentences who_holds(const EngineAnswers& answers) {
  Sentences hold, directed, said;
  bool asked = false;
  for (const EngineRow& row : answers.rows()) {
    const Holding seen = holding(answers, row);
    if (!seen.asked || !seen.creep_asked) continue;
    asked = true;
    if (seen.holds()) hold.push_back(row.name());
    if (seen.most - seen.least > kDirected) {
      directed.push_back(
          seen.least <= -90.0
              ? fmt::format("{} (gives on every slope, or on none)", row.name())
              : fmt::format("{} ({:+.2g}° to {:+.2g}°)", row.name(), seen.least, seen.most));
    }
  }
  if (!asked) return said;
  said.push_back(
      fmt::format("Creep below {} m/s at 90 % of the critical slope and give within {}° "
                  "of it, in every direction asked: {}",
                  format_error(kCreeps), kGivesOff, hold.empty() ? "none" : listed_names(hold)));
  if (!directed.empty()) {
    said.push_back("The slope that gives depends on the direction in which it falls: " +
                   listed_names(directed));
  }
  return said;
}

Sentences who_breaks(const EngineAnswers& answers) {
  Sentences broke;
  for (const EngineRow& row : answers.rows()) {
    Sentences on;
    for (const Question& question : answers.questions()) {
      if (answers.of(question, row).broke()) on.push_back(question.id);
    }
    if (!on.empty()) broke.push_back(fmt::format("{} ({})", row.name(), listed_names(on)));
  }
  return broke.empty() ? broke : Sentences{"Broke: " + listed_names(broke)};
}

}  // namespace

std::vector<std::string> engine_findings(const EngineAnswers& answers) {
  Sentences said;
  const auto add = [&](Sentences more) { said.insert(said.end(), more.begin(), more.end()); };
  if (const EngineRow* const our = our_row(answers)) {
    add(closer_than_ours(answers, *our));
    add(cheaper_than_ours(answers));
  }
  add(builds_findings(answers));
  add(who_holds(answers));
  add(who_breaks(answers));
  return said;
}

}  // namespace stiction
