// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engine/conformance/conformance.h"

#include <fmt/format.h>

#include <utility>

#include "solver/demand.h"
#include "validation/engine/conformance/probe.h"

namespace stiction {

namespace {

struct Check {
  const char* name;
  std::string (*run)(const Probe&);
};

constexpr Check kChecks[] = {{"bodies and poses", check_start},
                             {"known velocity", check_velocity},
                             {"free fall", check_free_fall},
                             {"rotation", check_spin},
                             {"forces and couples", check_loads},
                             {"weight at rest", check_weight},
                             {"friction on an obstacle", check_friction},
                             {"friction between bodies", check_pair_friction},
                             {"saved states", check_snapshots},
                             {"runs repeat", check_repeats}};

Finding find(const Check& check, const Probe& probe) {
  try {
    return {check.name, Conformity::kHolds, check.run(probe)};
  } catch (const NotApplicable& words) {
    return {check.name, Conformity::kNotApplicable, words.what()};
  } catch (const std::exception& words) {
    return {check.name, Conformity::kFails, words.what()};
  }
}

}  // namespace

std::vector<Finding> check_conformance(const EngineKind& kind, const Settings& settings) {
  const Probe probe(kind, settings);
  std::vector<Finding> found;
  for (const Check& check : kChecks) found.push_back(find(check, probe));
  return found;
}

void demand_conformance(const EngineKind& kind, const Settings& settings) {
  if (kind.program.empty()) return;
  std::vector<Settings> ways = {{}};
  if (kind.configurations) {
    ways.clear();
    for (Configuration& one : kind.configurations("")) ways.push_back(std::move(one.settings));
  }
  for (Settings& way : ways) {
    for (const auto& [name, value] : settings) way[name] = value;
    for (const Finding& one : check_conformance(kind, way)) {
      if (one.conformity != Conformity::kFails) continue;
      throw InputError(fmt::format(
          "the engine '{}' is not graded, for its adapter fails the check of {}: {}; './stiction "
          "engine check \"{}\"' shows all checks",
          kind.name, one.name, one.sentence, kind.program));
    }
  }
}

}  // namespace stiction
