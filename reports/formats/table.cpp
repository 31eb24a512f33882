// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "reports/formats/verdict_word.h"
#include "reports/text/check_text.h"
#include "reports/text/configuration_text.h"
#include "reports/text/family.h"
#include "reports/text/number.h"
#include "reports/text/text.h"

namespace stiction {
namespace {

constexpr std::size_t kValueWidth = 12;     // "-1.23457e-05"
constexpr std::size_t kErrorWidth = 12;     // "-1.2e-05 rel"
constexpr std::size_t kLeastQuantity = 15;  // the heading
constexpr std::size_t kWideTerminal = 96;   // columns from which on there is room for full headings
constexpr std::string_view kIndent = "  ";

// What a narrow terminal has in shorter form.
struct Layout {
  std::string_view gap, digits, share;
};

Layout layout_of(const Screen& screen) {
  return screen.width >= kWideTerminal ? Layout{"  ", "digits", " of tol."}
                                       : Layout{" ", "dig.", "of tol."};
}

std::size_t quantity_width(const Screen& screen) {
  const auto [gap, digits, share] = layout_of(screen);
  const std::size_t others = kIndent.size() + kVerdictWidth + 2 * kValueWidth + kErrorWidth +
                             digits.size() + share.size() + 6 * gap.size();
  return std::max(kLeastQuantity, screen.width > others ? screen.width - others : 0);
}

struct CheckCells {
  std::string verdict;  // padded already: it may hold colour codes, which take no columns
  std::vector<std::string> quantity;  // lines
  std::string value, expected, error, digits, share;
};

std::string check_line(const CheckCells& cells, const Screen& screen) {
  const auto [gap, digits, share] = layout_of(screen);
  const std::array<std::string, 7> columns = {
      cells.verdict,
      padded_right(cells.quantity.front(), quantity_width(screen)),
      padded_left(cells.value, kValueWidth),
      padded_left(cells.expected, kValueWidth),
      padded_left(cells.error, kErrorWidth),
      padded_left(cells.digits, digits.size()),
      padded_left(cells.share, share.size())};
  std::string lines = fmt::format("{}{}\n", kIndent, fmt::join(columns, gap));
  const std::string below(kIndent.size() + kVerdictWidth + gap.size() + 2, ' ');
  for (std::size_t k = 1; k < cells.quantity.size(); ++k) lines += below + cells.quantity[k] + "\n";
  return lines;
}

// Nothing of a name is left out: what its column has no room for stands below.
std::vector<std::string> quantity_cell(const Judgement& check, const Screen& screen) {
  const std::string unit = one_line(check.claim.unit.empty() ? "1" : check.claim.unit);
  return wrapped(fmt::format("{} [{}]", one_line(check.claim.quantity), unit),
                 quantity_width(screen));
}

// `left` at the line's start, `right` at its end.
std::string spread(const std::string& left, const std::string& right, std::size_t width) {
  if (right.empty()) return left + "\n";
  const std::size_t room =
      std::max(display_width(left) + 2, width - std::min(width, display_width(right)));
  return padded_right(left, room) + right + "\n";
}

}  // namespace

std::string not_applicable_block(const std::vector<Record>& records, const Screen& screen) {
  std::map<std::string, std::map<std::string, int>> families;  // by reason
  for (const Record& record : records) {
    if (record.verdict != Verdict::kNotApplicable) continue;
    const std::string why = record.notes.empty() ? "no checks" : record.notes.front();
    ++families[why][family_name(record.case_name)];
  }
  std::string text;
  for (const auto& [why, counts] : families) {
    std::string list;
    for (const auto& [family, count] : counts) {
      list += fmt::format("{}{}", list.empty() ? "" : ", ", one_line(family));
      if (count > 1) list += fmt::format(" ({})", count);
    }
    const std::string plain = padded_right(verdict_word(Verdict::kNotApplicable), kVerdictWidth);
    std::string lines = bullet(why + ": " + list, screen.width, plain + "  ");
    text += lines.replace(0, plain.size(), verdict_cell(Verdict::kNotApplicable, screen));
  }
  return text;
}

std::string table_header(const Screen& screen) {
  const Layout layout = layout_of(screen);
  return spread("case  configuration", "contact phases of step", screen.width) +
         check_line({padded_right("", kVerdictWidth),
                     {"quantity [unit]"},
                     "measured",
                     "expected",
                     "error",
                     std::string(layout.digits),
                     std::string(layout.share)},
                    screen) +
         std::string(screen.width, '-') + "\n";
}

std::string table_rows(const Record& record, const Screen& screen) {
  const Cost& cost = record.cost;
  std::string rows =
      spread(one_line(record.case_name) + "  " + configuration_text(record),
             cost.whole_step.median > 0.0
                 ? fmt::format("{} of {} ns", format_seconds(cost.contact_phases.median),
                               format_seconds(cost.whole_step.median))
                 : std::string(),
             screen.width);
  for (const Judgement& check : record.checks) {
    rows +=
        check_line({verdict_cell(check.verdict, screen), quantity_cell(check, screen),
                    format_value(check.value), format_value(check.claim.expected),
                    format_error(check.error) + (check.claim.relative ? " rel" : ""),
                    check.digits ? format_digits(*check.digits) : std::string(), share_text(check)},
                   screen);
    // What follows the comma stands under the quantity.
    const std::size_t indent = kIndent.size() + kVerdictWidth + layout_of(screen).gap.size();
    if (check.band)
      rows += bullet(band_text(check).substr(2), screen.width, std::string(indent, ' '));
  }
  if (record.verdict == Verdict::kError || record.checks.empty()) {
    std::string why = record.error;
    if (why.empty() && !record.notes.empty()) why = record.notes.front();
    // The colour codes are put in afterwards, since wrapping counts columns.
    const std::string plain = padded_right(verdict_word(record.verdict), kVerdictWidth);
    std::string lines = bullet(why.empty() ? "no checks" : why, screen.width,
                               std::string(kIndent) + plain + std::string(layout_of(screen).gap));
    lines.replace(kIndent.size(), plain.size(), verdict_cell(record.verdict, screen));
    rows += lines;
  }
  return rows;
}

}  // namespace stiction
