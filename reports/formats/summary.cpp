// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "reports/formats/digits_survive.h"
#include "reports/formats/failure_block.h"
#include "reports/formats/how_accurate.h"
#include "reports/formats/summary_table.h"
#include "reports/formats/table.h"
#include "reports/formats/who_holds.h"
#include "reports/formats/why_short.h"
#include "reports/text/number.h"
#include "reports/text/standing.h"
#include "reports/text/tally.h"
#include "reports/text/text.h"

namespace stiction {
namespace {

std::string title_line(const std::vector<Record>& records, const Screen& screen,
                       double wall_seconds) {
  std::set<std::string> cases, engines, revisions;
  for (const Record& record : records) {
    cases.insert(record.case_name);
    engines.insert(one_line(record.engine));
    revisions.insert(one_line(record.environment.revision));
  }
  std::string who;
  for (const std::string& engine : engines) who += (who.empty() ? "" : ", ") + engine;
  if (engines != std::set<std::string>{"stiction"}) who = "stiction: " + who;
  if (revisions.size() == 1 && !revisions.begin()->empty()) who += " " + *revisions.begin();
  const double cpu = tally_of(records).cpu_seconds;
  std::string line = fmt::format("{} · {}, {} · ", who, counted(records.size(), "record"),
                                 counted(cases.size(), "case"));
  line += wall_seconds > 0.0
              ? fmt::format("{} ({} s CPU)", duration_text(wall_seconds), format_seconds(cpu))
              : fmt::format("{} s CPU", format_seconds(cpu));
  return bullet(line, screen.width, "");
}

std::string verdict_line(const Tally& tally, const Screen& screen) {
  std::string line =
      fmt::format("{} fail, {} broke off · {} hold · {} fall short as expected", tally.fail,
                  tally.error, tally.pass, tally.shortfall + tally.refuted);
  if (tally.refuted > 0) line += fmt::format(" ({} refute the paper)", tally.refuted);
  if (tally.information > 0) line += fmt::format(" · {} for information", tally.information);
  if (tally.not_applicable > 0) line += fmt::format(" · {} not applicable", tally.not_applicable);
  line = bullet(line, screen.width, "");
  if (tally.fail + tally.error == 0 || !screen.colour) return line;
  return "\033[1;31m" + line.substr(0, line.size() - 1) + "\033[0m\n";
}

// How much is shown of the parts.
struct Fill {
  bool airy;  // with empty lines between them, and with why something is not applicable
  std::size_t accuracies, reasons;
};

// A terminal gets the first that it has room for. What is not applicable is counted above, so that a low
// one can do without why.
constexpr std::array<Fill, 7> kFills = {{{true, kMostSummaryRows, 100},
                                         {true, 6, 6},
                                         {true, 5, 4},
                                         {true, 4, 3},
                                         {false, 5, 4},
                                         {false, 4, 3},
                                         {false, 3, 2}}};

std::size_t lines_in(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

std::string summary_screen(const std::vector<Record>& records, const Screen& screen,
                           double wall_seconds) {
  if (records.empty()) return "no records\n";
  constexpr std::size_t kBelow = 3;  // two lines that tell where the reports are, and the prompt
  const Standings standings = standings_of(records);
  const std::string head = title_line(records, screen, wall_seconds) +
                           verdict_line(tally_of(records), screen) + failing_lines(records, screen);
  std::string text;
  for (const Fill& fill : kFills) {
    text = head;
    for (const std::string& part :
         {who_holds(standings, screen), how_accurate(standings, fill.accuracies, screen),
          digits_survive(records, 2 * fill.accuracies, screen),
          ladder_ends(records, fill.accuracies, screen),
          fill.airy ? not_applicable_block(records, screen) : std::string(),
          why_short(records, fill.reasons, screen)}) {
      if (!part.empty()) text += (fill.airy ? "\n" : "") + part;
    }
    if (fill.airy) text += "\n";
    if (screen.height == 0 || lines_in(text) + kBelow <= screen.height) break;
  }
  return text;
}

}  // namespace stiction
