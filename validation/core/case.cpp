// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/core/case.h"

#include <algorithm>
#include <utility>

#include "validation/stability/perturbed_case.h"

namespace stiction {

std::vector<Settings> variants_of(const Case& which, const EngineKind& engine, bool full) {
  if (!which.variants.empty()) return which.variants;
  if (!engine.configurations) return {{}};
  std::vector<Settings> all;
  for (Configuration& one : engine.configurations(which.name)) {
    if (full || !one.only_full) all.push_back(std::move(one.settings));
  }
  return all;
}

bool for_contrast(const Case& which, const EngineKind& engine, const Settings& settings) {
  if (!which.variants.empty() || !engine.configurations) return false;
  const std::vector<Configuration> all = engine.configurations(which.name);
  return std::any_of(all.begin(), all.end(), [&](const Configuration& one) {
    return one.contrast && one.settings == settings;
  });
}

std::vector<Case> cases_for(const EngineKind& engine) {
  std::vector<Case> all = case_catalog();
  for (Case& one : perturbed_cases(all)) all.push_back(std::move(one));
  if (engine.studies) {
    for (Case& one : engine.studies()) all.push_back(std::move(one));
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Case& a, const Case& b) { return a.name < b.name; });
  return all;
}

}  // namespace stiction
