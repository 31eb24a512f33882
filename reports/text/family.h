// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "reports/record/record.h"

namespace stiction {

/// Records of one case family, in natural order of their case names (numbers by value, so that
/// dt=1e-4 stands before dt=1e-3), whatever order parallel jobs finished in.
struct Family {
  std::string name;                                    ///< e.g. "incline/threshold"
  std::vector<const Record*> records;                  ///< never empty; owned by the caller
  std::map<std::string, std::string> common_settings;  ///< equal in all records; with the engine

  /// What tells a record from its siblings: the case name behind the family's, then the settings
  /// that differ within the family, e.g. "mu=0.3/azimuth=30 rule=none". One line; not escaped.
  std::string label(const Record& record) const;
};

/// The family of a case: the path components before the first parameter ("name=value"), at most
/// two; the whole name when it has one component. "incline/threshold/mu=0.3" → "incline/threshold".
std::string family_name(const std::string& case_name);

/// Families in natural order of their names. The pointers live as long as `records` is unchanged.
std::vector<Family> families_of(const std::vector<Record>& records);

/// Whether `a` stands before `b` when runs of digits compare by value.
bool natural_less(std::string_view a, std::string_view b);

}  // namespace stiction
