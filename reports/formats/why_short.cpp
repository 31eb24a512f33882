// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/why_short.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "reports/formats/summary_table.h"
#include "reports/text/configuration_text.h"
#include "reports/text/family.h"
#include "reports/text/text.h"

namespace stiction {
namespace {

constexpr std::size_t kWide = 100;  // columns from which on there is room for who falls short

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

}  // namespace

std::string why_short(const std::vector<Record>& records, std::size_t most, const Screen& screen) {
  const auto reasons = reasons_of(records);
  if (reasons.empty()) return "";
  std::size_t total = 0;
  for (const auto& [words, reason] : reasons) total += reason.records;
  Cells rows;
  const bool all = reasons.size() <= most;
  for (const auto& [words, reason] : reasons) {
    if (!all && rows.size() + 1 >= most) break;
    std::string who;
    for (const std::string& name : reason.who) who += (who.empty() ? "" : ", ") + name;
    rows.push_back({std::to_string(reason.records), words, who, reason.example});
    if (screen.width < kWide) rows.back().erase(rows.back().begin() + 2);
  }
  std::string text = fmt::format("Why {} fall{} short as expected\n", total, total == 1 ? "s" : "");
  text += summary_table(rows, {1, 2, 3}, screen);
  if (!all)
    text += fmt::format("{}and {} more causes, in report.md\n", kSummaryIndent,
                        reasons.size() - rows.size());
  return text;
}

}  // namespace stiction
