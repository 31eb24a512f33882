// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/comparison_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/text/check_text.h"
#include "validation/comparison/comparison.h"
#include "validation/comparison/figures.h"

namespace stiction {

namespace {

using Row = std::vector<std::string>;

std::string number(double value) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return "never";
  if (value == std::floor(value) && std::abs(value) < 1e6) return fmt::format("{:.0f}", value);
  return fmt::format("{:.2g}", value);
}

std::string heading(const Figure& figure) {
  return figure.unit == "1" ? figure.quantity : figure.quantity + ", " + figure.unit;
}

}  // namespace

std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char sign) {
    return (static_cast<unsigned char>(sign) & 0xC0) != 0x80;
  }));
}

std::string aligned_table(const std::vector<std::vector<std::string>>& rows, std::size_t texts) {
  std::vector<std::size_t> width(rows.front().size(), 0);
  for (const Row& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], letters(row[c]));
  }
  const auto is_text = [&](std::size_t column) { return column < texts; };
  std::string text;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      const std::string gap(width[c] - letters(rows[r][c]), ' ');
      text += "| " + (is_text(c) ? rows[r][c] + gap : gap + rows[r][c]) + " ";
    }
    text += "|\n";
    if (r > 0) continue;
    for (std::size_t c = 0; c < width.size(); ++c) {
      text += "|" + std::string(width[c] + 1, '-') + (is_text(c) ? "-" : ":");
    }
    text += "|\n";
  }
  return text;
}

double friction_nanoseconds(const Record& record) {
  const auto found = record.cost.phase_seconds.find("friction");
  if (found == record.cost.phase_seconds.end() || record.cost.contact_updates == 0) return 0.0;
  return 1e9 * found->second / static_cast<double>(record.cost.contact_updates);
}

double figure(const Record& record, const std::string& quantity) {
  for (const Figure& one : record.figures) {
    if (one.quantity == quantity) return one.value;
  }
  return std::nan("");
}

std::string comparison_table(const std::vector<const Record*>& records) {
  Row head{"rule", "contacts"};
  // An errored record has no figures; the heading is that of the first that has.
  for (const Record* record : records) {
    for (const Figure& figure : record->figures) head.push_back(heading(figure));
    if (head.size() > 2) break;
  }
  head.push_back("friction, ns");
  std::vector<Row> rows{head};
  std::string failures;
  for (const Record* record : records) {
    const RuleOnContacts who = who_of(*record);
    Row row{who.rule + (who.build.empty() ? "" : ", " + who.build), who.contacts};
    for (const Figure& figure : record->figures) row.push_back(number(figure.value));
    row.resize(head.size() - 1, "–");
    const double nanoseconds = friction_nanoseconds(*record);
    row.push_back(nanoseconds > 0.0 ? number(std::round(nanoseconds)) : "–");
    rows.push_back(row);
    for (const Failure& failure : record->failures) {
      failures += fmt::format("{}{}, {} contacts: {}", failures.empty() ? "Failed: " : "; ", row[0],
                              row[1], failure_text(failure));
    }
  }
  return aligned_table(rows, 2) + (failures.empty() ? "" : "\n" + failures + "\n");
}

}  // namespace stiction
