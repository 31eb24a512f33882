// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>

#include "solver/friction/rule.h"

// Written by the build from the headers of rules/: STICTION_FRICTION_RULES(X) expands to
// X(None, "none") X(FixedPoint, "fixed-point") …
#include "solver/friction/friction_rules.inc"

namespace stiction {

// The rules as types. What asks of rules by their names includes catalog.h, and isn't compiled again
// for another rule.

/// Calls `use(rule)` with the rule of that name, constructed with the values `given`; true if there
/// is one.
template <class Use>
bool with_friction_rule(const std::string& name, const RuleSettings& given, Use&& use) {
#define STICTION_TRY_RULE(Rule, word) \
  if (name == word) {                 \
    use(Rule(given));                 \
    return true;                      \
  }
  STICTION_FRICTION_RULES(STICTION_TRY_RULE)
#undef STICTION_TRY_RULE
  return false;
}

/// The parameters of a rule.
template <class Rule>
constexpr std::span<const RuleParameter> parameters_of() {
  if constexpr (requires { Rule::kParameters; }) {
    return Rule::kParameters;
  } else {
    return {};
  }
}

}  // namespace stiction
