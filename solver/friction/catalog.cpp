// SPDX-License-Identifier: BSD-3-Clause
#include "solver/friction/catalog.h"

#include <algorithm>

namespace stiction {

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

}  // namespace stiction
