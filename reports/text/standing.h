// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reports/record/record.h"

namespace stiction {

/// Whether something decides of a record: an error, or a check that is not for information.
bool is_judged(const Record& record);

/// Whether all claims of a record hold, whatever was expected of them: each decided check passes. A
/// record that is not judged, or with an error, doesn't hold.
bool holds(const Record& record);

/// How a configuration stands beside the others.
struct Standing {
  std::string name;  ///< the configuration; behind the engine's name where there are several
  std::vector<const Record*> records{};  ///< those counted, which must outlive this
  std::size_t held = 0;                  ///< records whose claims all hold
  std::size_t ran = 0;                   ///< records that are judged
  std::size_t not_judged = 0;            ///< records for information
  bool compared = false;                 ///< it ran the cases that are compared
  // Of these cases alone where it is compared, else of all that it ran:
  std::size_t held_shared = 0;  ///< records
  std::size_t shared = 0;       ///< records
  double cpu_seconds = 0.0;     ///< summed
  std::size_t ended_early = 0;  ///< records of one simulation that took fewer steps than others
  // Of all that it ran:
  std::optional<double> least_at_rest{};  ///< least share of scenes at rest
  std::optional<double> most_at_rest{};   ///< largest
  std::optional<double> slip{};           ///< fastest contact's, worst, m/s
  std::optional<double> drift{};          ///< worst in 10 s, m
  bool creeps = false;                    ///< a slip, drift or creep is beyond its tolerance
};

struct Standings {
  std::vector<Standing> rows;    ///< those that hold most first
  std::size_t shared_cases = 0;  ///< that all the compared ones ran
  std::size_t compared = 0;      ///< configurations
};

/// The cases compared are those of the configurations for which (pairs of configurations) × (cases
/// that all of them ran) is largest, so that one that ran little doesn't make the comparison empty.
Standings standings_of(const std::vector<Record>& records);

}  // namespace stiction
