// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/workloads/workload.h"

namespace stiction::bench {

/// An optional feature, as it is measured: a scene that does not use it, and one that does.
struct OptionalFeature {
  std::string
      name;  ///< "self-collision": see solver/CMakeLists.txt; step_without_<name> is built without it
  std::string title;  ///< what is set to use it, or not
  Workload (*prepare)(bool used);
};

std::vector<OptionalFeature> optional_features();

/// Instructions of a step, by callgrind.
struct FeatureCost {
  std::string name;
  std::string title;
  double without = 0.0;  ///< the unused scene, by a build without the feature
  double unused = 0.0;   ///< the same scene by the usual build
  double used = 0.0;     ///< the scene with the feature used
};

/// Measures all of them with the programs step_with_all and step_without_<name> beside this one.
/// Nothing, and `why_not` in words, where callgrind is missing or fails. `next` is told the name of
/// each before it is measured.
std::optional<std::vector<FeatureCost>> measure_features(
    std::string& why_not, const std::function<void(const std::string&)>& next = {});

/// The work of those programs: after the scene has come to rest, `steps` steps, all of them in
/// `measured_steps`, at whose entry and exit callgrind starts and stops to collect.
void measured_steps(Workload& work, int steps, PhaseSeconds* clock);
int run_step_program(int argc, char** argv);

}  // namespace stiction::bench
