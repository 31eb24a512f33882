// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/user/quantity.h"

#include <charconv>
#include <cmath>
#include <numbers>

namespace stiction {

namespace {

// Not by a library: UDUNITS [2.2.28] takes a radian for the number 1, so that 60 rpm would be 6.28 Hz
// and an angle a share, and does not know "deg".
struct Unit {
  std::string_view name, base;
  double times, over = 1.0;  // both whole where they can be: 3 mm are 0.003 m to the last bit
};

constexpr double kPi = std::numbers::pi;

constexpr Unit kUnits[] = {
    {"m", "m", 1},
    {"mm", "m", 1, 1e3},
    {"cm", "m", 1, 1e2},
    {"um", "m", 1, 1e6},
    {"µm", "m", 1, 1e6},
    {"km", "m", 1e3},
    {"s", "s", 1},
    {"ms", "s", 1, 1e3},
    {"us", "s", 1, 1e6},
    {"µs", "s", 1, 1e6},
    {"min", "s", 60},
    {"kg", "kg", 1},
    {"g", "kg", 1, 1e3},
    {"mg", "kg", 1, 1e6},
    {"t", "kg", 1e3},
    {"Pa", "Pa", 1},
    {"kPa", "Pa", 1e3},
    {"MPa", "Pa", 1e6},
    {"GPa", "Pa", 1e9},
    {"N/mm2", "Pa", 1e6},
    {"N/mm²", "Pa", 1e6},
    {"N", "N", 1},
    {"mN", "N", 1, 1e3},
    {"kN", "N", 1e3},
    {"N m", "N m", 1},
    {"N mm", "N m", 1, 1e3},
    {"N cm", "N m", 1, 1e2},
    {"kN m", "N m", 1e3},
    {"N/m", "N/m", 1},
    {"N/mm", "N/m", 1e3},
    {"kN/m", "N/m", 1e3},
    {"J", "J", 1},
    {"mJ", "J", 1, 1e3},
    {"kJ", "J", 1e3},
    {"m/s", "m/s", 1},
    {"mm/s", "m/s", 1, 1e3},
    {"cm/s", "m/s", 1, 1e2},
    {"um/s", "m/s", 1, 1e6},
    {"µm/s", "m/s", 1, 1e6},
    {"km/h", "m/s", 1e3, 3.6e3},
    {"m/s²", "m/s²", 1},
    {"m/s2", "m/s²", 1},
    {"m/s^2", "m/s²", 1},
    {"mm/s²", "m/s²", 1, 1e3},
    {"mm/s2", "m/s²", 1, 1e3},
    {"mm/s^2", "m/s²", 1, 1e3},
    {"rad/s", "rad/s", 1},
    {"deg/s", "rad/s", kPi, 180},
    {"rpm", "rad/s", kPi, 30},
    {"Hz", "Hz", 1},
    {"kHz", "Hz", 1e3},
    {"rpm", "Hz", 1, 60},
    {"1/s", "1/s", 1},
    {"1/ms", "1/s", 1e3},
    {"deg", "deg", 1},
    {"°", "deg", 1},
    {"rad", "deg", 180, kPi},
    {"1", "1", 1},
    {"%", "1", 1, 1e2},
};

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(' ');
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

}  // namespace

std::optional<double> quantity_in(std::string_view unit, std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || !std::isfinite(number)) return std::nullopt;
  const std::string_view behind = trimmed(text.substr(static_cast<std::size_t>(end - text.data())));
  for (const Unit& one : kUnits) {
    if (one.base != unit || one.name != behind) continue;
    const double value = number * one.times / one.over;
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
  }
  return std::nullopt;
}

std::string shown_unit(const std::string& unit) { return unit == "deg" ? "°" : unit; }

std::vector<std::string_view> units_like(std::string_view unit) {
  std::vector<std::string_view> names;
  for (const Unit& one : kUnits) {
    if (one.base == unit) names.push_back(one.name);
  }
  return names;
}

}  // namespace stiction
