// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engine/settings.h"

#include <charconv>
#include <cmath>

#include "reports/text/names.h"
#include "solver/demand.h"

namespace stiction {

Settings merged(Settings base, const Settings& over) {
  for (const auto& [name, value] : over) base[name] = value;
  return base;
}

namespace {

double parse_number(const std::string& name, const std::string& word) {
  double value = 0.0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) {
    throw InputError("setting '" + name + "' needs a finite number, not '" + word + "'");
  }
  return value;
}

}  // namespace

bool SettingsReader::has(const std::string& name) {
  known_[name] = true;
  return settings_.count(name) > 0;
}

std::string SettingsReader::text(const std::string& name, const std::string& fallback) {
  return has(name) ? settings_.at(name) : fallback;
}

double SettingsReader::number(const std::string& name, double fallback) {
  return has(name) ? parse_number(name, settings_.at(name)) : fallback;
}

int SettingsReader::count(const std::string& name, int fallback) {
  if (!has(name)) return fallback;
  const double value = number(name, 0.0);
  if (value != std::floor(value) || value < 1.0 || value > 1e6) {
    throw InputError("setting '" + name + "' needs a whole number from 1 to 1000000, not '" +
                     settings_.at(name) + "'");
  }
  return static_cast<int>(value);
}

void SettingsReader::refuse_unknown(const std::string& engine) const {
  for (const auto& [name, value] : settings_) {
    if (known_.count(name) > 0) continue;
    throw InputError("engine '" + engine + "' has no setting '" + name + "'; there are: " +
                     listed_names(known_, [](const auto& word) { return word.first; }));
  }
}

}  // namespace stiction
