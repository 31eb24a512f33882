// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "reports/screen/progress_line.h"
#include "reports/screen/screen.h"
#include "reports/text/check_text.h"
#include "reports/text/configuration_text.h"
#include "reports/text/family.h"
#include "reports/text/number.h"
#include "reports/text/standing.h"
#include "reports/text/tally.h"
#include "reports/text/text.h"

namespace stiction {
namespace {

constexpr std::size_t kMostRows = 8;  // of a part
constexpr std::size_t kRoomy = 90;    // columns from which on there is room between columns
constexpr std::size_t kWide = 100;    // … and for who falls short
constexpr std::string_view kIndent = "  ";

// Rows of cells, the first a heading; columns in `texts` are text, the others numbers.
std::string columns(const std::vector<std::vector<std::string>>& rows,
                    const std::set<std::size_t>& texts, const TableStyle& style) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t c = 0; c < row.size(); ++c) {
      widths[c] = std::max(widths[c], display_width(row[c]));
    }
  }
  const std::string gap(style.width < kRoomy ? 1 : 2, ' ');
  std::string text;
  for (const auto& row : rows) {
    std::string line(kIndent);
    for (std::size_t c = 0; c < row.size(); ++c) {
      line += (c == 0 ? "" : gap) + (texts.contains(c) ? padded_right(row[c], widths[c])
                                                       : padded_left(row[c], widths[c]));
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string title_line(const std::vector<Record>& records, const TableStyle& style,
                       const RunFacts& facts) {
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
  line += facts.wall_seconds > 0.0
              ? fmt::format("{} ({} s CPU)", duration_text(facts.wall_seconds), format_seconds(cpu))
              : fmt::format("{} s CPU", format_seconds(cpu));
  return block("", line, 0, style);
}

std::string verdict_line(const Tally& tally, const TableStyle& style) {
  std::string line =
      fmt::format("{} fail, {} broke off · {} hold · {} fall short as expected", tally.fail,
                  tally.error, tally.pass, tally.shortfall + tally.refuted);
  if (tally.refuted > 0) line += fmt::format(" ({} refute the paper)", tally.refuted);
  if (tally.information > 0) line += fmt::format(" · {} for information", tally.information);
  if (tally.not_applicable > 0) line += fmt::format(" · {} not applicable", tally.not_applicable);
  line = block("", line, 0, style);
  if (tally.fail + tally.error == 0 || !style.colour) return line;
  return "\033[1;31m" + line.substr(0, line.size() - 1) + "\033[0m\n";
}

std::string failure_words(const Judgement& check) {
  if (check.band) return band_text(check);
  // A scaled tolerance is not in the record.
  if (check.of_tolerance <= 1.0) return ": beyond its scaled tolerance";
  return fmt::format(": {} its tolerance", share_text(check.of_tolerance));
}

// The names of those that fail, each with its worst check.
std::string failing_lines(const std::vector<Record>& records, const TableStyle& style) {
  std::vector<const Record*> bad;
  for (const Record& record : records) {
    if (record.verdict == Verdict::kFail || record.verdict == Verdict::kError)
      bad.push_back(&record);
  }
  std::string text;
  for (std::size_t k = 0; k < std::min(bad.size(), kMostRows); ++k) {
    const Record& record = *bad[k];
    const Judgement* const worst = worst_check(record.checks);
    std::string what = record.error;
    if (what.empty() && worst != nullptr) {
      what = one_line(worst->claim.quantity) + failure_words(*worst);
    }
    const std::string plain = padded_right(verdict_word(record.verdict), kVerdictWidth);
    std::string lines = block(
        plain + "  ",
        fmt::format("{}  {}: {}", one_line(record.case_name), configuration_text(record), what),
        kIndent.size(), style);
    text += lines.replace(kIndent.size(), plain.size(), verdict_cell(record.verdict, style));
  }
  if (bad.size() > kMostRows) {
    text +=
        fmt::format("{}and {} more, each whole in report.md\n", kIndent, bad.size() - kMostRows);
  }
  return text;
}

std::string size_text(const std::optional<double>& value) {
  if (!value) return "–";
  if (std::isnan(*value)) return "broke";
  return *value == 0.0 ? std::string("0") : fmt::format("{:.0e}", *value);
}

std::string rest_text(const Standing& row) {
  if (!row.least_at_rest) return "–";
  const double low = 100.0 * *row.least_at_rest, high = 100.0 * *row.most_at_rest;
  return low == high ? fmt::format("{:.3g} %", low) : fmt::format("{:.2g}–{:.2g} %", low, high);
}

std::string standings_text(const Standings& standings, const TableStyle& style) {
  if (standings.rows.empty()) return "";
  const bool compared = standings.compared > 1;
  const auto any = [&](auto field) {
    return std::any_of(standings.rows.begin(), standings.rows.end(),
                       [&](const Standing& row) { return (row.*field).has_value(); });
  };
  const bool rest = any(&Standing::least_at_rest), slip = any(&Standing::slip),
             drift = any(&Standing::drift);
  std::size_t early = 0;
  std::vector<std::vector<std::string>> rows(1);
  rows[0] = {""};
  if (compared) rows[0].push_back("hold");
  rows[0].push_back(compared ? "of all" : "hold");
  rows[0].push_back("CPU s");
  if (rest) rows[0].push_back("at rest");
  if (slip) rows[0].push_back("slip, m/s");
  if (drift) rows[0].push_back("drift, m");
  rows[0].push_back("");
  for (const Standing& row : standings.rows) {
    if (rows.size() > kMostRows) break;
    std::vector<std::string> cells = {row.name};
    if (compared) {
      cells.push_back(row.compared ? fmt::format("{}/{}", row.held_shared, row.shared) : "–");
    }
    cells.push_back(fmt::format("{}/{}", row.held, row.ran));
    const bool has_cost = !compared || row.compared;
    cells.push_back(!has_cost ? "–"
                              : (row.ended_early > 0 ? "*" : "") + format_seconds(row.cpu_seconds));
    if (rest) cells.push_back(rest_text(row));
    if (slip) cells.push_back(size_text(row.slip));
    if (drift) cells.push_back(size_text(row.drift));
    std::string words = row.creeps ? "creeps" : row.held == row.ran ? "holds" : "";
    if (row.not_judged > 0 && style.width >= kRoomy) {
      words += fmt::format("{}+{} not judged", words.empty() ? "" : ", ", row.not_judged);
    }
    cells.push_back(words);
    if (has_cost) early += row.ended_early;
    rows.push_back(cells);
  }
  std::string title = "Who holds";
  if (compared) {
    title +=
        fmt::format(" (hold, CPU: the {} that {} ran{})", counted(standings.shared_cases, "case"),
                    standings.compared == standings.rows.size()
                        ? std::string("all")
                        : fmt::format("the first {}", standings.compared),
                    early > 0 ? fmt::format("; * {} ended early", counted(early, "run")) : "");
  }
  return block("", title, 0, style) + columns(rows, {0, rows[0].size() - 1}, style);
}

struct Accuracy {
  const Record* record = nullptr;
  const Judgement* check = nullptr;
};

// Each headline's check that takes most of its tolerance, those that take most first.
std::vector<std::pair<std::string, Accuracy>> headlines(const std::vector<const Record*>& records) {
  std::vector<std::pair<std::string, Accuracy>> found;
  for (const Record* record : records) {
    for (const Judgement& check : record->checks) {
      if (check.claim.headline.empty() || check.verdict == Verdict::kForInformation) continue;
      const auto same = std::find_if(found.begin(), found.end(), [&](const auto& one) {
        return one.first == check.claim.headline;
      });
      if (same == found.end()) {
        found.push_back({check.claim.headline, {record, &check}});
      } else if (check.of_tolerance > same->second.check->of_tolerance) {
        same->second = {record, &check};
      }
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return a.second.check->of_tolerance > b.second.check->of_tolerance;
  });
  return found;
}

// The passing check that takes most of its tolerance; none where all are exact.
Accuracy nearest_to_failing(const std::vector<const Record*>& records) {
  Accuracy nearest;
  for (const Record* record : records) {
    for (const Judgement& check : record->checks) {
      if (check.verdict != Verdict::kPass || check.of_tolerance == 0.0) continue;
      if (nearest.check == nullptr || check.of_tolerance > nearest.check->of_tolerance) {
        nearest = {record, &check};
      }
    }
  }
  return nearest;
}

std::string accuracy_text(const Standings& standings, std::size_t most, const TableStyle& style) {
  if (standings.rows.empty()) return "";
  const Standing& leader = standings.rows.front();
  std::vector<std::vector<std::string>> rows = {{"", "error", "tolerance", "of it", ""}};
  for (const auto& [name, at] : headlines(leader.records)) {
    if (rows.size() > most) break;
    rows.push_back({one_line(name), error_text(*at.check), tolerance_text(*at.check),
                    share_text(at.check->of_tolerance),
                    at.check->verdict == Verdict::kPass
                        ? std::string()
                        : std::string(verdict_word(at.check->verdict))});
  }
  std::string text = fmt::format("How accurate ({})\n", leader.name);
  if (rows.size() > 1) text += columns(rows, {0, 4}, style);
  const Accuracy nearest = nearest_to_failing(leader.records);
  if (nearest.check != nullptr) {
    text += block(
        "nearest to failing: ",
        fmt::format("{} of the tolerance, {}: {}", share_text(nearest.check->of_tolerance),
                    one_line(nearest.record->case_name), one_line(nearest.check->claim.quantity)),
        kIndent.size(), style);
  }
  return rows.size() > 1 || nearest.check != nullptr ? text : "";
}

struct Reason {
  std::size_t records = 0;
  std::set<std::string> who;
  std::string example;
  double beyond = 0.0;  // its record's share of the tolerance
};

std::vector<std::pair<std::string, Reason>> reasons_of(const std::vector<Record>& records) {
  std::map<std::string, Reason> reasons;
  for (const Record& record : records) {
    if (record.verdict != Verdict::kShortfall && record.verdict != Verdict::kRefuted) continue;
    const Judgement* const worst = worst_check(record.checks);
    if (worst == nullptr) continue;
    const std::string& words = worst->because.empty() ? worst->cause : worst->because;
    Reason& reason = reasons[one_line(words.substr(0, words.find(" (band:")))];
    ++reason.records;
    const std::string name = configuration_name(record);
    reason.who.insert(name.substr(0, name.find(',')));  // "paper" of its rules
    if (reason.example.empty() || worst->of_tolerance > reason.beyond) {
      reason.example = one_line(family_name(record.case_name));
      reason.beyond = worst->of_tolerance;
    }
  }
  std::vector<std::pair<std::string, Reason>> sorted(reasons.begin(), reasons.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    return a.second.records > b.second.records;
  });
  return sorted;
}

// At most `most` lines below its heading.
std::string reasons_text(const std::vector<Record>& records, std::size_t most,
                         const TableStyle& style) {
  const auto reasons = reasons_of(records);
  if (reasons.empty()) return "";
  std::size_t total = 0;
  for (const auto& [words, reason] : reasons) total += reason.records;
  std::vector<std::vector<std::string>> rows;
  const bool all = reasons.size() <= most;
  for (const auto& [words, reason] : reasons) {
    if (!all && rows.size() + 1 >= most) break;
    std::string who;
    for (const std::string& name : reason.who) who += (who.empty() ? "" : ", ") + name;
    rows.push_back({std::to_string(reason.records), words, who, reason.example});
    if (style.width < kWide) rows.back().erase(rows.back().begin() + 2);
  }
  std::string text = fmt::format("Why {} fall{} short as expected\n", total, total == 1 ? "s" : "");
  text += columns(rows, {1, 2, 3}, style);
  if (!all)
    text +=
        fmt::format("{}and {} more causes, in report.md\n", kIndent, reasons.size() - rows.size());
  return text;
}

std::size_t lines_in(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

std::string summary_screen(const std::vector<Record>& records, const TableStyle& style,
                           const RunFacts& facts) {
  if (records.empty()) return "no records\n";
  const Standings standings = standings_of(records);
  const std::string head = title_line(records, style, facts) +
                           verdict_line(tally_of(records), style) + failing_lines(records, style);
  // How much of what is shown: the first that a terminal has room for. What is not applicable is
  // counted above, so that a low one can do without why.
  struct Fill {
    bool airy;
    std::size_t accuracies, reasons;
  };
  constexpr std::array<Fill, 7> kFills = {{{true, kMostRows, 100},
                                           {true, 6, 6},
                                           {true, 5, 4},
                                           {true, 4, 3},
                                           {false, 5, 4},
                                           {false, 4, 3},
                                           {false, 3, 2}}};
  constexpr std::size_t kBelow = 3;  // two lines that tell where the reports are, and the prompt
  std::string text;
  for (const Fill& fill : kFills) {
    text = head;
    for (const std::string& part :
         {standings_text(standings, style), accuracy_text(standings, fill.accuracies, style),
          fill.airy ? not_applicable_block(records, style) : std::string(),
          reasons_text(records, fill.reasons, style)}) {
      if (!part.empty()) text += (fill.airy ? "\n" : "") + part;
    }
    if (fill.airy) text += "\n";
    if (facts.height == 0 || lines_in(text) + kBelow <= facts.height) break;
  }
  return text;
}

std::string failure_block(const Record& record, const TableStyle& style, const std::string& rerun) {
  if (record.verdict != Verdict::kFail && record.verdict != Verdict::kError) return "";
  constexpr std::size_t kTextIndent = kVerdictWidth + 2;
  std::string text = fmt::format("{}  {}  {}\n", verdict_cell(record.verdict, style),
                                 one_line(record.case_name), configuration_text(record));
  text += block("", record.error, kTextIndent, style);
  for (const Judgement& check : record.checks) {
    if (check.verdict != Verdict::kFail && check.verdict != Verdict::kError) continue;
    text += block("", check_sentence(check), kTextIndent, style);
    text += block("worst at:  ", check.worst, kTextIndent + 2, style);
    text += block("tolerance: ", check.claim.reason, kTextIndent + 2, style);
    if (check.band) text += block("cause of the band: ", check.cause, kTextIndent + 2, style);
  }
  for (const std::string& note : record.notes) text += block("note: ", note, kTextIndent, style);
  // Whole on one line, to be copied.
  text += std::string(kTextIndent, ' ') +
          "again: " + (rerun.empty() ? rerun_command(record) : one_line(rerun)) + "\n";
  return text;
}

}  // namespace stiction
