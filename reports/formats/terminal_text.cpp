// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/terminal_text.h"

#include "reports/text/text.h"

namespace stiction {
namespace {

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

}  // namespace

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

std::string verdict_cell(Verdict verdict, const TableStyle& style) {
  const std::string cell = padded_right(verdict_word(verdict), kVerdictWidth);
  if (!style.colour) return cell;
  return std::string(colour_code(verdict)) + cell + "\033[0m";
}

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

}  // namespace stiction
