// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <map>
#include <string>

namespace stiction {

/// A number that a friction rule can be given. The header of the rule declares it; settings, help,
/// records and the check of a user's values find it there (catalog.h).
struct RuleParameter {
  const char* name;        ///< as in settings, e.g. "slip-tolerance"
  const char* help;        ///< what it is, a phrase
  const char* unit = "1";  ///< SI; "1": dimensionless
  double initial = 0.0;    ///< the default, in the range
  /// What it may be: any finite number from `low` to `high`, …
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool open = false;  ///< … but not these two themselves
  /// A switch: the words of 0 and of 1, which are all that it can be. Null: a number.
  const char* off = nullptr;
  const char* on = nullptr;
  bool told_when_set = false;      ///< a record names it only where it is not the default
  const char* replaces = nullptr;  ///< where it is not the default, this one has no effect
};

/// What rules share.
namespace parameter {

/// The paper's observed convergence implies 0.58 – 0.82; the loop is stable for 0 < g < 2 (less
/// where contacts couple).
inline constexpr RuleParameter kGain{
    .name = "gain", .help = "g, the share of a step's slip that is learned", .initial = 0.7};
inline constexpr RuleParameter kMemory{.name = "memory",
                                       .help = "what was learned, when the contact slips",
                                       .off = "reset",
                                       .on = "keep"};

}  // namespace parameter

/// Values of parameters that are not their defaults, by name.
using RuleSettings = std::map<std::string, double, std::less<>>;

inline double value_of(const RuleParameter& parameter, const RuleSettings& given) {
  const auto found = given.find(parameter.name);
  return found == given.end() ? parameter.initial : found->second;
}

/// … of a switch: whether it is on.
inline bool is_on(const RuleParameter& parameter, const RuleSettings& given) {
  return value_of(parameter, given) != 0.0;
}

/// What the parameter may be, in words: "at least 0", "between 0 and 2", "reset or keep".
std::string range_words(const RuleParameter& parameter);

/// Why the parameter cannot have this value, one sentence; empty if it can.
std::string refusal_of(const RuleParameter& parameter, double value);

}  // namespace stiction
