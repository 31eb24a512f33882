// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

// Written by the build from the headers of rules/: STICTION_FRICTION_RULES(X) expands to
// X(None, "none") X(FixedPoint, "fixed-point") …
#include "solver/friction/friction_rules.inc"

namespace stiction {

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

inline bool is_friction_rule(const std::string& name) {
  return with_friction_rule(name, {}, [](const auto&) {});
}

/// What the rule of that name, which exists, says of itself; and the bytes that it keeps of a
/// contact from step to step: its values, the contact's key and its status.
inline RuleCard friction_rule_card(const std::string& name) {
  RuleCard card{};
  with_friction_rule(name, {}, [&](const auto& rule) { card = rule.kCard; });
  return card;
}
inline std::size_t friction_memory_bytes(const std::string& name) {
  std::size_t bytes = sizeof(ContactKey) + sizeof(ContactStatus);
  with_friction_rule(name, {}, [&](const auto& rule) { bytes += rule.kValues * sizeof(Real); });
  return bytes;
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

/// … of that name, which exists.
inline std::span<const RuleParameter> friction_rule_parameters(const std::string& name) {
  std::span<const RuleParameter> parameters;
  with_friction_rule(name, {}, [&](const auto& rule) {
    parameters = parameters_of<std::remove_cvref_t<decltype(rule)>>();
  });
  return parameters;
}

/// Why a rule with these parameters cannot be given these values, one sentence that names the rule;
/// empty if it can.
std::string refusal_of(const std::string& rule, std::span<const RuleParameter> parameters,
                       const RuleSettings& given);

/// Names of all rules.
inline std::vector<std::string> friction_rule_names() {
  std::vector<std::string> names;
#define STICTION_NAME_RULE(Rule, word) names.emplace_back(word);
  STICTION_FRICTION_RULES(STICTION_NAME_RULE)
#undef STICTION_NAME_RULE
  return names;
}

/// … comma-separated.
inline std::string friction_rule_list() {
  std::string list;
  for (const std::string& name : friction_rule_names()) list += (list.empty() ? "" : ", ") + name;
  return list;
}

}  // namespace stiction
