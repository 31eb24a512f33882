// SPDX-License-Identifier: BSD-3-Clause
#include "solver/friction/catalog.h"

#include <algorithm>
#include <type_traits>

#include "solver/contact/contacts.h"
#include "solver/friction/with_rule.h"

namespace stiction {

bool is_friction_rule(const std::string& name) {
  return with_friction_rule(name, {}, [](const auto&) {});
}

RuleCard friction_rule_card(const std::string& name) {
  RuleCard card{};
  with_friction_rule(name, {}, [&](const auto& rule) { card = rule.kCard; });
  return card;
}

int friction_rule_values(const std::string& name) {
  int values = 0;
  with_friction_rule(name, {}, [&](const auto& rule) { values = rule.kValues; });
  return values;
}

std::size_t friction_memory_bytes(const std::string& name) {
  return sizeof(ContactKey) + sizeof(ContactStatus) +
         static_cast<std::size_t>(friction_rule_values(name)) * sizeof(Real);
}

std::span<const RuleParameter> friction_rule_parameters(const std::string& name) {
  std::span<const RuleParameter> parameters;
  with_friction_rule(name, {}, [&](const auto& rule) {
    parameters = parameters_of<std::remove_cvref_t<decltype(rule)>>();
  });
  return parameters;
}

std::string refusal_of(const std::string& rule, std::span<const RuleParameter> parameters,
                       const RuleSettings& given) {
  for (const auto& [name, value] : given) {
    const auto found =
        std::find_if(parameters.begin(), parameters.end(),
                     [&, &name = name](const RuleParameter& one) { return name == one.name; });
    if (found == parameters.end()) {
      std::string known;
      for (const RuleParameter& one : parameters) {
        known += (known.empty() ? "" : ", ") + std::string(one.name);
      }
      return "rule '" + rule + "' has no parameter '" + name + "'; it has " +
             (known.empty() ? "none" : known);
    }
    const std::string wrong = refusal_of(*found, value);
    if (!wrong.empty()) return "rule '" + rule + "': " + wrong;
  }
  return {};
}

std::vector<std::string> friction_rule_names() {
  std::vector<std::string> names;
#define STICTION_NAME_RULE(Rule, word) names.emplace_back(word);
  STICTION_FRICTION_RULES(STICTION_NAME_RULE)
#undef STICTION_NAME_RULE
  return names;
}

std::string friction_rule_list() {
  std::string list;
  for (const std::string& name : friction_rule_names()) list += (list.empty() ? "" : ", ") + name;
  return list;
}

}  // namespace stiction
