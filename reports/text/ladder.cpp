// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/text/ladder.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <tuple>

namespace stiction {

namespace {

// Decades from 1; nothing is as far as can be.
double wildness(double value) {
  return value == 0.0 ? std::numeric_limits<double>::infinity()
                      : std::abs(std::log(std::abs(value)));
}

void find_ends(Climb& climb) {
  const std::vector<Rung>& rungs = climb.rungs;
  const auto tamest =
      std::min_element(rungs.begin(), rungs.end(), [](const Rung& a, const Rung& b) {
        if (a.holds() != b.holds()) return a.holds();
        return wildness(a.value) < wildness(b.value);
      });
  const auto at = static_cast<std::size_t>(tamest - rungs.begin());
  if (!tamest->holds()) {
    climb.above = &*tamest;
    return;
  }
  std::size_t low = at, high = at;
  while (low > 0 && rungs[low - 1].holds()) --low;
  while (high + 1 < rungs.size() && rungs[high + 1].holds()) ++high;
  climb.lowest = &rungs[low];
  climb.highest = &rungs[high];
  if (low > 0) climb.below = &rungs[low - 1];
  if (high + 1 < rungs.size()) climb.above = &rungs[high + 1];
}

}  // namespace

bool Rung::holds() const {
  if (record->verdict != Verdict::kForInformation) return record->verdict == Verdict::kPass;
  const auto within = [](const Judgement& check) { return check.of_tolerance <= 1.0; };
  return std::all_of(record->checks.begin(), record->checks.end(), within);
}

std::optional<Rung> rung_of(const Record& record) {
  constexpr std::string_view kFamily = "ladder/";
  const std::string& name = record.case_name;
  const std::size_t slash = name.rfind('/'), equals = name.rfind('=');
  if (!name.starts_with(kFamily) || slash < kFamily.size() || equals == std::string::npos ||
      equals < slash || record.verdict == Verdict::kNotApplicable) {
    return std::nullopt;
  }
  const char* const begin = name.c_str() + equals + 1;
  char* end = nullptr;
  const double value = std::strtod(begin, &end);
  if (end == begin || *end != '\0' || std::isnan(value)) return std::nullopt;
  return Rung{name.substr(kFamily.size(), slash - kFamily.size()),
              name.substr(slash + 1, equals - slash - 1), value, &record};
}

std::vector<Climb> climbs_of(const std::vector<Record>& records) {
  std::vector<Climb> climbs;
  for (const Record& record : records) {
    const std::optional<Rung> rung = rung_of(record);
    if (!rung) continue;
    const auto key = [](const Climb& one) {
      return std::tie(one.engine, one.configuration, one.ladder, one.parameter);
    };
    Climb wanted{record.engine, record.configuration, rung->ladder, rung->parameter, {}};
    auto found = std::find_if(climbs.begin(), climbs.end(),
                              [&](const Climb& one) { return key(one) == key(wanted); });
    if (found == climbs.end()) found = climbs.insert(climbs.end(), std::move(wanted));
    found->rungs.push_back(*rung);
  }
  for (Climb& climb : climbs) {
    std::stable_sort(climb.rungs.begin(), climb.rungs.end(),
                     [](const Rung& a, const Rung& b) { return a.value < b.value; });
    find_ends(climb);
  }
  return climbs;
}

}  // namespace stiction
