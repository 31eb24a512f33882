// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/text/check_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/text/number.h"
#include "reports/text/text.h"

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

std::string band_text(const Check& check) {
  if (!check.band) return {};
  const auto [low, high] = *check.band;
  const std::string ends = with_unit(fmt::format("[{}, {}]", format_value(low), format_value(high)),
                                     one_line(check.unit));
  const bool inside = check.value >= low && check.value <= high;
  if (inside && check.verdict != Verdict::kFail) return ", as expected in " + ends;
  if (std::isnan(check.value)) return ", no number where it is expected in " + ends;
  // Nearer to the claim than the band's nearest end; a value in the band that fails holds its
  // claim.
  const double nearest = std::min(std::abs(low - check.expected), std::abs(high - check.expected));
  const bool better = inside || std::abs(check.value - check.expected) < nearest;
  return better ? ", better than known " + ends + ": raise the bar"
                : ", worse than expected " + ends;
}

std::string check_sentence(const Check& check) {
  const std::string unit = one_line(check.unit);
  return fmt::format("{}: measured {}, expected {} ({}), error {}, tolerance {}{}",
                     one_line(check.quantity), with_unit(format_value(check.value), unit),
                     with_unit(format_value(check.expected), unit), to_string(check.kind),
                     error_text(check), tolerance_text(check), band_text(check));
}

std::string settings_text(const std::map<std::string, std::string>& settings) {
  std::string text;
  for (const auto& [name, value] : settings) {
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", one_line(name), one_line(value));
  }
  return text;
}

}  // namespace stiction
