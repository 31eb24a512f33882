// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "validation/engine/engine.h"

namespace stiction {

/// `base` with `over` laid over it.
Settings merged(Settings base, const Settings& over);

/// Reads settings one by one and remembers which were asked for, so that an unknown name is refused
/// with the list of known ones.
class SettingsReader {
 public:
  explicit SettingsReader(const Settings& settings) : settings_(settings) {}

  /// The setting's text, or `fallback`.
  std::string text(const std::string& name, const std::string& fallback);
  /// The setting as a finite number, or `fallback`. Throws InputError if it is no number.
  double number(const std::string& name, double fallback);
  /// The setting as a whole number ≥ 1, or `fallback`. Throws InputError.
  int count(const std::string& name, int fallback);
  bool has(const std::string& name);
  /// Throws InputError if a setting was given that nobody asked for.
  void refuse_unknown(const std::string& engine) const;

 private:
  const Settings& settings_;
  std::map<std::string, bool> known_;
};

}  // namespace stiction
