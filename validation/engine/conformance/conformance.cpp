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
                             {"sines over time", check_sines},
                             {"weight at rest", check_weight},
                             {"friction on an obstacle", check_friction},
                             {"friction between bodies", check_pair_friction},
                             {"friction of single pairs", check_single_pairs},
                             {"restitution", check_restitution},
                             {"saved states", check_snapshots},
                             {"runs repeat", check_repeats},
                             {"finer steps", check_finer}};

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
  struct Way {
    std::string name;
    Settings settings;
  };
  std::vector<Way> ways;
  if (kind.configurations) {
    for (const Configuration& one : kind.configurations("")) {
      ways.push_back({one.name, one.settings});
    }
  }
  if (ways.empty()) ways.push_back({"", {}});
  for (Way& way : ways) {
    for (const auto& [name, value] : settings) way.settings[name] = value;
  }
  std::vector<Finding> found;
  for (const Check& check : kChecks) {
    std::string elsewhere;
    Finding finding;
    for (const Way& way : ways) {
      finding = find(check, Probe(kind, way.settings));
      if (finding.conformity != Conformity::kFails) break;
      if (ways.size() > 1)
        elsewhere += fmt::format("; configuration '{}': {}", way.name, finding.sentence);
    }
    const bool fails = finding.conformity == Conformity::kFails;
    if (!elsewhere.empty())
      finding.sentence = fails ? elsewhere.substr(2) : finding.sentence + elsewhere;
    found.push_back(std::move(finding));
  }
  return found;
}

void demand_conformance(const EngineKind& kind, const Settings& settings) {
  if (kind.program.empty()) return;
  for (const Finding& one : check_conformance(kind, settings)) {
    if (one.conformity != Conformity::kFails) continue;
    throw InputError(fmt::format(
        "the engine '{}' is not graded, for its adapter fails the check of {}: {}; './stiction "
        "engine check \"{}\"' shows all checks",
        kind.name, one.name, one.sentence, kind.program));
  }
}

}  // namespace stiction
