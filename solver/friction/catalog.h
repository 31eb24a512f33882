// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cctype>
#include <string>
#include <tuple>

// Written by the build from the headers of this folder: STICTION_FRICTION_RULES(X) expands to
// X(None, "none") X(FixedPoint, "fixed-point") …
#include "friction_rules.inc"

namespace stiction {

/// Calls `use(rule)` with the rule of that name, constructed from `parameters`; true if there is
/// one.
template <class Use>
bool with_friction_rule(const std::string& name, const FrictionParameters& parameters, Use&& use) {
#define STICTION_TRY_RULE(Rule, word) \
  if (name == word) {                 \
    use(Rule(parameters));            \
    return true;                      \
  }
  STICTION_FRICTION_RULES(STICTION_TRY_RULE)
#undef STICTION_TRY_RULE
  return false;
}

inline bool is_friction_rule(const std::string& name) {
  return with_friction_rule(name, {}, [](const auto&) {});
}

/// Names of all rules, comma-separated.
inline std::string friction_rule_list() {
  std::string list;
#define STICTION_NAME_RULE(Rule, word) list += std::string(list.empty() ? "" : ", ") + word;
  STICTION_FRICTION_RULES(STICTION_NAME_RULE)
#undef STICTION_NAME_RULE
  return list;
}

}  // namespace stiction
