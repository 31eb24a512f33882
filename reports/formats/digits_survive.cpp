// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/digits_survive.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "reports/formats/summary_table.h"
#include "reports/text/ladder.h"
#include "reports/text/text.h"

namespace stiction {
namespace {

constexpr std::string_view kPerturbed = "perturbed/";

// Of one perturbation in one configuration.
struct Fewest {
  const Judgement* check = nullptr;
  const Record* record = nullptr;
};

struct Survival {
  std::string group;
  std::map<std::string, Fewest> of;  // by configuration
  double fewest = 17.0;
};

std::string digits_word(const Judgement& check) {
  if (check.value == 0.0) return "exact";
  return check.digits && *check.digits > 0.0 ? fmt::format("{:.1f}", *check.digits) : "none";
}

std::string way_of(const Record& record) {
  return record.engine == "stiction" ? record.configuration
                                     : record.engine + ", " + record.configuration;
}

std::string value_words(double value) { return fmt::format("{:g}", value); }

// Of what is for information, which nothing decides.
const Judgement* farthest(const std::vector<Judgement>& checks) {
  const auto found = std::max_element(
      checks.begin(), checks.end(),
      [](const Judgement& a, const Judgement& b) { return a.of_tolerance < b.of_tolerance; });
  return found == checks.end() ? nullptr : &*found;
}

std::string why_it_breaks(const Rung& rung) {
  const Record& record = *rung.record;
  if (!record.error.empty()) return record.error;
  const Judgement* check = worst_check(record.checks);
  if (check == nullptr) check = farthest(record.checks);
  if (check == nullptr) return "";
  return check->because.empty() ? check->claim.quantity
                                : check->claim.quantity + ": " + check->because;
}

}  // namespace

std::string digits_survive(const std::vector<Record>& records, std::size_t most,
                           const Screen& screen) {
  std::vector<Survival> all;
  std::vector<std::string> ways;
  std::set<std::string> cases;
  for (const Record& record : records) {
    if (!record.case_name.starts_with(kPerturbed)) continue;
    cases.insert(record.case_name);
    const std::string way = one_line(way_of(record));
    if (std::find(ways.begin(), ways.end(), way) == ways.end()) ways.push_back(way);
    for (const Judgement& check : record.checks) {
      auto found = std::find_if(all.begin(), all.end(), [&](const Survival& one) {
        return one.group == check.claim.quantity;
      });
      if (found == all.end()) found = all.insert(all.end(), {check.claim.quantity, {}, 17.0});
      const double digits = check.digits.value_or(0.0);
      Fewest& fewest = found->of[way];
      if (fewest.check == nullptr || digits < fewest.check->digits.value_or(0.0)) {
        fewest = {&check, &record};
      }
      found->fewest = std::min(found->fewest, digits);
    }
  }
  if (all.empty()) return "";
  std::stable_sort(all.begin(), all.end(),
                   [](const Survival& a, const Survival& b) { return a.fewest < b.fewest; });
  Cells rows = {{""}};
  for (const std::string& way : ways) rows[0].push_back(way);
  rows[0].emplace_back("fewest in");
  for (const Survival& one : all) {
    if (rows.size() > most) break;
    rows.push_back({one_line(one.group)});
    const Fewest* worst = nullptr;
    for (const std::string& way : ways) {
      const auto found = one.of.find(way);
      rows.back().push_back(found == one.of.end() ? "–" : digits_word(*found->second.check));
      if (found != one.of.end() && (worst == nullptr || found->second.check->digits.value_or(0.0) <
                                                            worst->check->digits.value_or(0.0))) {
        worst = &found->second;
      }
    }
    rows.back().push_back(one_line(worst->record->case_name.substr(kPerturbed.size())));
  }
  return fmt::format("Digits that survive ({})\n", counted(cases.size(), "case")) +
         summary_table(rows, {0, ways.size() + 1}, screen);
}

std::string ladder_ends(const std::vector<Record>& records, std::size_t most,
                        const Screen& screen) {
  const std::vector<Climb> climbs = climbs_of(records);
  if (climbs.empty()) return "";
  std::set<std::string> ways;
  for (const Climb& climb : climbs) ways.insert(climb.engine + climb.configuration);
  Cells rows = {{"", "holds", "breaks at", "where"}};
  std::string whole;
  std::size_t breaking = 0;
  for (const Climb& climb : climbs) {
    std::string name = one_line(climb.ladder);
    if (ways.size() > 1) name += " (" + one_line(way_of(*climb.rungs.front().record)) + ")";
    const Rung* const broken = climb.above != nullptr ? climb.above : climb.below;
    if (broken == nullptr) {
      whole += (whole.empty() ? "" : ", ") + name;
      continue;
    }
    if (++breaking > most) continue;
    rows.push_back({name,
                    climb.lowest == nullptr ? "nowhere"
                                            : value_words(climb.lowest->value) + " … " +
                                                  value_words(climb.highest->value),
                    value_words(broken->value), one_line(why_it_breaks(*broken))});
  }
  std::string text = fmt::format("Ladders, {} rungs\n", [&] {
    std::size_t count = 0;
    for (const Climb& climb : climbs) count += climb.rungs.size();
    return count;
  }());
  if (rows.size() > 1) text += summary_table(rows, {0, 1, 3}, screen);
  if (breaking > most) text += fmt::format("{}and {} more\n", kSummaryIndent, breaking - most);
  if (!whole.empty()) {
    text += bullet(whole, screen.width, std::string(kSummaryIndent) + "hold on every rung: ");
  }
  return text;
}

}  // namespace stiction
