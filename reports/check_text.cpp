// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/check_text.h"

#include <fmt/format.h>

#include "reports/number.h"
#include "reports/text.h"

namespace stiction {
namespace {

std::string error_unit(const Check& check) { return check.relative ? "rel" : one_line(check.unit); }

}  // namespace

std::string error_text(const Check& check) {
  return with_unit(format_error(check.error), error_unit(check));
}

std::string tolerance_text(const Check& check) {
  return with_unit(format_error(check.tolerance), error_unit(check));
}

std::string check_sentence(const Check& check) {
  const std::string unit = one_line(check.unit);
  return fmt::format("{}: measured {}, expected {} ({}), error {}, tolerance {}",
                     one_line(check.quantity), with_unit(format_value(check.value), unit),
                     with_unit(format_value(check.expected), unit), to_string(check.kind),
                     error_text(check), tolerance_text(check));
}

std::string settings_text(const std::map<std::string, std::string>& settings) {
  std::string text;
  for (const auto& [name, value] : settings) {
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", one_line(name), one_line(value));
  }
  return text;
}

}  // namespace stiction
