// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "solver/friction/rule.h"

namespace stiction {

/// Whether there is a rule of that name.
bool is_friction_rule(const std::string& name);

/// What the rule of that name, which exists, says of itself; the values that it keeps of a contact
/// from step to step; and the bytes of these, of the contact's key and of its status.
RuleCard friction_rule_card(const std::string& name);
int friction_rule_values(const std::string& name);
std::size_t friction_memory_bytes(const std::string& name);

/// The parameters of the rule of that name, which exists.
std::span<const RuleParameter> friction_rule_parameters(const std::string& name);

/// Why a rule with these parameters cannot be given these values, one sentence that names the rule;
/// empty if it can.
std::string refusal_of(const std::string& rule, std::span<const RuleParameter> parameters,
                       const RuleSettings& given);

/// Names of all rules.
std::vector<std::string> friction_rule_names();

/// … comma-separated.
std::string friction_rule_list();

}  // namespace stiction
