// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/verdict_word.h"

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

std::string verdict_cell(Verdict verdict, const Screen& screen) {
  const std::string cell = padded_right(verdict_word(verdict), kVerdictWidth);
  if (!screen.colour) return cell;
  return std::string(colour_code(verdict)) + cell + "\033[0m";
}

}  // namespace stiction
