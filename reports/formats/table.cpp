// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "reports/text/check_text.h"
#include "reports/text/family.h"
#include "reports/text/number.h"
#include "reports/text/tally.h"
#include "reports/text/text.h"

namespace stiction {
namespace {

constexpr std::size_t kVerdictWidth = 7;    // "refuted"
constexpr std::size_t kValueWidth = 12;     // "-1.23457e-05"
constexpr std::size_t kErrorWidth = 12;     // "-1.2e-05 rel"
constexpr std::size_t kLeastQuantity = 15;  // the heading
constexpr std::size_t kWideTerminal = 96;   // columns from which on there is room for full headings
constexpr std::string_view kIndent = "  ";

// What a narrow terminal has in shorter form.
struct Layout {
  std::string_view gap, digits, share;
};

Layout layout_of(const TableStyle& style) {
  return style.width >= kWideTerminal ? Layout{"  ", "digits", " of tol."}
                                      : Layout{" ", "dig.", "of tol."};
}

// Words as seen on the terminal: what needs attention is in capitals, with or without colour.
std::string_view verdict_word(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPass:
      return "pass";
    case Verdict::kFail:
      return "FAIL";
    case Verdict::kShortfall:
      return "short";
    case Verdict::kRefuted:
      return "refuted";
    case Verdict::kNotApplicable:
      return "n/a";
    case Verdict::kForInformation:
      return "info";
    case Verdict::kError:
      return "ERROR";
  }
  return "?";
}

std::string_view colour_code(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPass:
      return "\033[32m";  // green
    case Verdict::kFail:
    case Verdict::kError:
      return "\033[1;31m";  // bold red
    case Verdict::kShortfall:
    case Verdict::kRefuted:
      return "\033[33m";  // yellow
    case Verdict::kNotApplicable:
    case Verdict::kForInformation:
      return "\033[2m";  // dim
  }
  return "";
}

std::string verdict_cell(Verdict verdict, const TableStyle& style) {
  const std::string cell = padded_right(verdict_word(verdict), kVerdictWidth);
  if (!style.colour) return cell;
  return std::string(colour_code(verdict)) + cell + "\033[0m";
}

std::size_t quantity_width(const TableStyle& style) {
  const auto [gap, digits, share] = layout_of(style);
  const std::size_t others = kIndent.size() + kVerdictWidth + 2 * kValueWidth + kErrorWidth +
                             digits.size() + share.size() + 6 * gap.size();
  return std::max(kLeastQuantity, style.width > others ? style.width - others : 0);
}

struct Cells {
  std::string verdict;  // padded already: it may hold colour codes, which take no columns
  std::string quantity, value, expected, error, digits, share;
};

std::string check_line(const Cells& cells, const TableStyle& style) {
  const auto [gap, digits, share] = layout_of(style);
  const std::array<std::string, 7> columns = {cells.verdict,
                                              padded_right(cells.quantity, quantity_width(style)),
                                              padded_left(cells.value, kValueWidth),
                                              padded_left(cells.expected, kValueWidth),
                                              padded_left(cells.error, kErrorWidth),
                                              padded_left(cells.digits, digits.size()),
                                              padded_left(cells.share, share.size())};
  return fmt::format("{}{}\n", kIndent, fmt::join(columns, gap));
}

// The unit is what a reader cannot guess, so a long name is cut before it.
std::string quantity_cell(const Judgement& check, const TableStyle& style) {
  const std::size_t width = quantity_width(style);
  const std::string unit =
      fmt::format(" [{}]", one_line(check.claim.unit.empty() ? "1" : check.claim.unit));
  const std::size_t unit_width = std::min(display_width(unit), width / 2);
  return shortened(one_line(check.claim.quantity), width - unit_width) +
         shortened(unit, unit_width);
}

// `left` at the line's start, `right` at its end.
std::string spread(const std::string& left, const std::string& right, std::size_t width) {
  if (right.empty()) return left + "\n";
  const std::size_t room =
      std::max(display_width(left) + 2, width - std::min(width, display_width(right)));
  return padded_right(left, room) + right + "\n";
}

// Lines behind a label, the continuation lines aligned with the first.
std::string block(std::string_view label, std::string_view text, std::size_t indent,
                  const TableStyle& style) {
  const std::size_t start = indent + display_width(label);
  const std::size_t room = style.width > start + 20 ? style.width - start : 20;
  std::string result;
  for (const std::string& line : wrapped(one_line(text), room)) {
    result +=
        result.empty() ? std::string(indent, ' ') + std::string(label) : std::string(start, ' ');
    result += line + "\n";
  }
  return result;
}

std::string record_name(const Record& record) {
  const std::string settings = settings_text(record.settings);
  return one_line(record.case_name) + (settings.empty() ? "" : "  " + settings);
}

std::string failure_block(const Record& record, const TableStyle& style) {
  constexpr std::size_t kTextIndent = kVerdictWidth + 2;
  std::string text = verdict_cell(record.verdict, style) + "  " + record_name(record) + "\n";
  text += block("", record.error, kTextIndent, style);
  for (const Judgement& check : record.checks) {
    if (check.verdict != Verdict::kFail && check.verdict != Verdict::kError) continue;
    text += block("", check_sentence(check), kTextIndent, style);
    text += block("worst at:  ", check.worst, kTextIndent + 2, style);
    text += block("tolerance: ", check.claim.reason, kTextIndent + 2, style);
    if (check.band) text += block("cause of the band: ", check.cause, kTextIndent + 2, style);
  }
  for (const std::string& note : record.notes) text += block("note: ", note, kTextIndent, style);
  return text;
}

// Why, and of which families how many: an engine that lacks much would bury what ran.
std::string not_applicable_block(const std::vector<Record>& records, const TableStyle& style) {
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
    std::string lines = block(plain + "  ", why + ": " + list, 0, style);
    text += lines.replace(0, plain.size(), verdict_cell(Verdict::kNotApplicable, style));
  }
  return text.empty() ? text : text + "\n";
}

}  // namespace

std::string table_header(const TableStyle& style) {
  const Layout layout = layout_of(style);
  return spread("case  settings", "ns/contact", style.width) +
         check_line({padded_right("", kVerdictWidth), "quantity [unit]", "measured", "expected",
                     "error", std::string(layout.digits), std::string(layout.share)},
                    style) +
         std::string(style.width, '-') + "\n";
}

std::string table_rows(const Record& record, const TableStyle& style) {
  const double ns = record.cost.ns_per_contact_update;
  std::string rows = spread(record_name(record),
                            ns > 0.0 ? fmt::format("{:.3g} ns", ns) : std::string(), style.width);
  for (const Judgement& check : record.checks) {
    rows +=
        check_line({verdict_cell(check.verdict, style), quantity_cell(check, style),
                    format_value(check.value), format_value(check.claim.expected),
                    format_error(check.error) + (check.claim.relative ? " rel" : ""),
                    check.digits ? format_digits(*check.digits) : std::string(), share_text(check)},
                   style);
    // What follows the comma stands under the quantity.
    const std::size_t indent = kIndent.size() + kVerdictWidth + layout_of(style).gap.size();
    if (check.band) rows += block("", band_text(check).substr(2), indent, style);
  }
  if (record.verdict == Verdict::kError || record.checks.empty()) {
    std::string why = record.error;
    if (why.empty() && !record.notes.empty()) why = record.notes.front();
    // The colour codes are put in afterwards, since wrapping counts columns.
    const std::string plain = padded_right(verdict_word(record.verdict), kVerdictWidth);
    std::string lines = block(plain + std::string(layout_of(style).gap),
                              why.empty() ? "no checks" : why, kIndent.size(), style);
    lines.replace(kIndent.size(), plain.size(), verdict_cell(record.verdict, style));
    rows += lines;
  }
  return rows;
}

std::string closing_summary(const std::vector<Record>& records, const TableStyle& style) {
  const Tally tally = tally_of(records);
  std::string summary = not_applicable_block(records, style);
  for (const Record& record : records) {
    if (record.verdict != Verdict::kFail && record.verdict != Verdict::kError) continue;
    summary += failure_block(record, style) + "\n";
  }
  summary += verdicts_text(tally) + "\n" + cost_text(tally) + "\n";
  return summary;
}

}  // namespace stiction
