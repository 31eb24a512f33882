// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/who_holds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "reports/formats/summary_table.h"
#include "reports/text/number.h"
#include "reports/text/text.h"

namespace stiction {
namespace {

std::string size_text(const std::optional<double>& value) {
  if (!value) return "–";
  if (std::isnan(*value)) return "broke";
  return *value == 0.0 ? std::string("0") : fmt::format("{:.0e}", *value);
}

std::string rest_text(const Standing& row) {
  if (!row.least_at_rest) return "–";
  const double low = 100.0 * *row.least_at_rest, high = 100.0 * *row.most_at_rest;
  return low == high ? fmt::format("{:.3g} %", low) : fmt::format("{:.2g}–{:.3g} %", low, high);
}

}  // namespace

std::string who_holds(const Standings& standings, const Screen& screen) {
  if (standings.rows.empty()) return "";
  const bool compared = standings.compared > 1;
  const auto any = [&](auto field) {
    return std::any_of(standings.rows.begin(), standings.rows.end(),
                       [&](const Standing& row) { return (row.*field).has_value(); });
  };
  const bool rest = any(&Standing::least_at_rest), slip = any(&Standing::slip),
             drift = any(&Standing::drift);
  std::size_t early = 0;
  std::vector<std::string> heading = {""};
  if (compared) heading.push_back("hold");
  heading.push_back(compared ? "of all" : "hold");
  heading.push_back("CPU s");
  if (rest) heading.push_back("at rest");
  if (slip) heading.push_back("slip, m/s");
  if (drift) heading.push_back("drift, m");
  heading.push_back("");
  Cells rows = {heading};
  for (const Standing& row : standings.rows) {
    if (rows.size() > kMostSummaryRows) break;
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
    if (row.not_judged > 0 && screen.width >= kRoomy) {
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
  return bullet(title, screen.width, "") + summary_table(rows, {0, heading.size() - 1}, screen);
}

}  // namespace stiction
