// SPDX-License-Identifier: BSD-3-Clause
// The functions of stiction_engine.h by which an engine reads its settings, or refuses.
#include "validation/engine/kit/run_settings.h"

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "validation/engine/kit/stiction_engine.h"

namespace stiction::kit {

RunSettings& told() {
  static RunSettings one;
  return one;
}

}  // namespace stiction::kit

using stiction::kit::told;

void stiction_refuse(const char* sentence) { throw std::runtime_error(sentence); }

void stiction_lacks(const char* words) { throw stiction::kit::Lacking(words); }

int stiction_has(const char* setting) { return told().given.count(setting) > 0 ? 1 : 0; }

const char* stiction_text(const char* setting, const char* fallback) {
  const auto found = told().given.find(setting);
  const std::string value = found == told().given.end() ? fallback : found->second;
  return told().resolved.insert_or_assign(setting, value).first->second.c_str();
}

double stiction_number(const char* setting, double fallback) {
  const auto found = told().given.find(setting);
  double value = fallback;
  if (found != told().given.end()) {
    char* end = nullptr;
    value = std::strtod(found->second.c_str(), &end);
    if (found->second.empty() || *end != '\0' || !std::isfinite(value)) {
      throw std::runtime_error(std::string("setting '") + setting + "' must be a number, not '" +
                               found->second + "'");
    }
  }
  stiction_tell_number(setting, value);
  return value;
}

void stiction_tell(const char* parameter, const char* value) {
  told().resolved.insert_or_assign(parameter, value);
}

void stiction_tell_number(const char* parameter, double value) {
  told().resolved.insert_or_assign(parameter, nlohmann::json(value).dump());
}
