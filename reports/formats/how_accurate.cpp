// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/how_accurate.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "reports/formats/summary_table.h"
#include "reports/formats/verdict_word.h"
#include "reports/text/check_text.h"
#include "reports/text/text.h"

namespace stiction {
namespace {

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

}  // namespace

std::string how_accurate(const Standings& standings, std::size_t most, const Screen& screen) {
  if (standings.rows.empty()) return "";
  const Standing& leader = standings.rows.front();
  Cells rows = {{"", "error", "tolerance", "of it", ""}};
  for (const auto& [name, at] : headlines(leader.records)) {
    if (rows.size() > most) break;
    rows.push_back({one_line(name), error_text(*at.check), tolerance_text(*at.check),
                    share_text(at.check->of_tolerance),
                    at.check->verdict == Verdict::kPass
                        ? std::string()
                        : std::string(verdict_word(at.check->verdict))});
  }
  std::string text = fmt::format("How accurate ({})\n", leader.name);
  if (rows.size() > 1) text += summary_table(rows, {0, 4}, screen);
  const Accuracy nearest = nearest_to_failing(leader.records);
  if (nearest.check != nullptr) {
    text +=
        bullet(fmt::format("{} of the tolerance, {}: {}", share_text(nearest.check->of_tolerance),
                           nearest.record->case_name, nearest.check->claim.quantity),
               screen.width, std::string(kSummaryIndent) + "nearest to failing: ");
  }
  return rows.size() > 1 || nearest.check != nullptr ? text : "";
}

}  // namespace stiction
