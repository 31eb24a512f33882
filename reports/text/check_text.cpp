// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/text/check_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/text/number.h"
#include "reports/text/text.h"

namespace stiction {
namespace {

std::string error_unit(const Judgement& check) {
  return check.claim.relative ? "rel" : one_line(check.claim.unit);
}

}  // namespace

std::string error_text(const Judgement& check) {
  return with_unit(format_error(check.error), error_unit(check));
}

std::string tolerance_text(const Judgement& check) {
  return with_unit(format_error(check.claim.tolerance), error_unit(check));
}

std::string share_text(double of_tolerance) {
  if (of_tolerance == 0.0) return "exact";
  if (!std::isfinite(of_tolerance)) return "∞";
  if (of_tolerance > 1e5) return fmt::format("{:.0e} ×", of_tolerance);
  if (of_tolerance < 1e-4) return "<0.01 %";
  // Two digits, without an exponent: 320 rather than 3.2e+02.
  const auto plain = [](double value) {
    return fmt::format("{:g}", std::stod(fmt::format("{:.2g}", value)));
  };
  // What is beyond its tolerance shall not read as 1.
  if (of_tolerance > 1.0 && of_tolerance < 1.05) return fmt::format("{:.4g} ×", of_tolerance);
  return of_tolerance > 1.0 ? plain(of_tolerance) + " ×" : plain(100.0 * of_tolerance) + " %";
}

std::string share_text(const Judgement& check) {
  return check.verdict == Verdict::kForInformation ? "" : share_text(check.of_tolerance);
}

std::string failure_text(const Failure& failure) {
  if (failure.values.empty()) return one_line(failure.reason);
  return fmt::format("{} at {} = {:g}", one_line(failure.reason), one_line(failure.parameter),
                     fmt::join(failure.values, ", "));
}

std::string band_text(const Judgement& check) {
  if (!check.band) return {};
  const auto [low, high] = *check.band;
  const std::string ends = with_unit(fmt::format("[{}, {}]", format_value(low), format_value(high)),
                                     one_line(check.claim.unit));
  const bool inside = check.value >= low && check.value <= high;
  if (inside && check.verdict != Verdict::kFail) return ", as expected in " + ends;
  if (std::isnan(check.value)) return ", no number where it is expected in " + ends;
  // Nearer to the claim than the band's nearest end; a value in the band that fails holds its
  // claim.
  const double nearest =
      std::min(std::abs(low - check.claim.expected), std::abs(high - check.claim.expected));
  const bool better = inside || std::abs(check.value - check.claim.expected) < nearest;
  return better ? ", better than known " + ends + ": raise the bar"
                : ", worse than expected " + ends;
}

// "analytic"; what comes from outside says from whom.
std::string reference_text(const Claim& claim) {
  const std::string kind(to_string(claim.kind));
  if (claim.kind != ReferenceKind::kExternal || claim.source.empty()) return kind;
  return kind + ": " + one_line(claim.source);
}

std::string check_sentence(const Judgement& check) {
  const std::string unit = one_line(check.claim.unit);
  return fmt::format("{}: measured {}, expected {} ({}), error {}, tolerance {}{}",
                     one_line(check.claim.quantity), with_unit(format_value(check.value), unit),
                     with_unit(format_value(check.claim.expected), unit),
                     reference_text(check.claim), error_text(check), tolerance_text(check),
                     band_text(check));
}

std::string settings_text(const std::map<std::string, std::string>& settings) {
  std::string text;
  for (const auto& [name, value] : settings) {
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", one_line(name), one_line(value));
  }
  return text;
}

}  // namespace stiction
