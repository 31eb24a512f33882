// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/record/record.h"

namespace stiction {

/// A record of a case "ladder/<name>/<parameter>=<value>".
struct Rung {
  std::string ladder;
  std::string parameter;
  double value = 0.0;
  const Record* record = nullptr;
  /// It passes; of what is for information: each check is within its tolerance.
  bool holds() const;
};

/// Nothing for a record of another kind, or one that is not applicable.
std::optional<Rung> rung_of(const Record& record);

/// What a ladder came to in one configuration.
struct Climb {
  std::string engine, configuration;
  std::string ladder, parameter;
  std::vector<Rung> rungs;  ///< by value
  /// The rungs that hold on end about the tamest, which is the one nearest to 1 of those that hold;
  /// null where none does.
  const Rung* lowest = nullptr;
  const Rung* highest = nullptr;
  const Rung* below = nullptr;  ///< the first that breaks below them, and above; null: none does
  const Rung* above = nullptr;
};

/// Pointers live as long as the records and the result.
std::vector<Climb> climbs_of(const std::vector<Record>& records);

}  // namespace stiction
