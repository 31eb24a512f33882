// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/text/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace stiction {
namespace {

// `finite` formats what is neither NaN nor infinite nor a negative zero.
template <typename Format>
std::string format_any(double value, Format finite) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
  return finite(value == 0.0 ? 0.0 : value);
}

}  // namespace

std::string format_value(double value) {
  return format_any(value, [](double finite) { return fmt::format("{:.6g}", finite); });
}

std::string format_error(double error) {
  return format_any(error, [](double finite) { return fmt::format("{:.2g}", finite); });
}

std::string format_digits(double digits) {
  return format_any(digits, [](double finite) { return fmt::format("{:.1f}", finite); });
}

std::string format_seconds(double seconds) {
  return format_any(seconds, [](double finite) {
    return std::abs(finite) < 999.5 ? fmt::format("{:.3g}", finite) : fmt::format("{:.0f}", finite);
  });
}

std::string duration_text(double seconds) {
  const long whole = std::lround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

std::string format_count(std::uint64_t count) {
  std::string text = std::to_string(count);
  for (std::size_t position = text.size(); position > 3;) {
    position -= 3;
    text.insert(position, 1, ',');
  }
  return text;
}

std::string spaced_count(std::uint64_t count) {
  std::string text = format_count(count);
  std::replace(text.begin(), text.end(), ',', ' ');
  return text;
}

std::string format_nanoseconds(double value) {
  return value < 9.95 ? fmt::format("{:.1f}", value) : fmt::format("{:.0f}", value);
}

std::string format_exact(double value) {
  if (std::isnan(value) || std::isinf(value)) return format_value(value);
  return fmt::format("{}", value);
}

std::string with_unit(const std::string& number, const std::string& unit) {
  return unit.empty() || unit == "1" ? number : number + " " + unit;
}

}  // namespace stiction
