// SPDX-License-Identifier: GPL-3.0-or-later
// How much of the cone the load takes, and from what slip friction has to be found: that of
// contacts that have lost their memory, or of a box that slides at 1e-3 m/s, where the paper counts
// from.
#include <fmt/format.h>

#include "validation/comparison/comparison.h"
#include "validation/comparison/rule_history.h"

namespace stiction {

namespace {

constexpr double kSlides = 1e-3;  // m/s

void run_released(CaseRun& run, const ComparisonScene& scene) {
  const RuleHistory history = run_rule(run, scene);
  report_history(run, history);
  report_from_sliding(run, history);
}

}  // namespace

std::vector<Case> comparisons_load() {
  std::vector<Case> cases;
  for (const double share : {0.1, 0.2, 0.35, 0.5, 0.73, 0.9, 0.95}) {
    for (const int cells : {2, 3}) {
      ComparisonScene scene = loaded_slab(share, cells);
      const std::string which = fmt::format("cells={}/r={}", cells, share);
      cases.push_back(
          {.name = "load/lost/" + which,
           .title = scene.title + ", and loses its friction memory",
           .set = share == 0.35 ? CaseSet::kQuick : CaseSet::kDefault,
           .variants = scalar_and_vector(),
           .run = [scene](CaseRun& run) { report_history(run, run_rule(run, scene)); }});
      scene.released = kSlides;
      cases.push_back({.name = "load/released/" + which,
                       .title = scene.title + ", and slides at 1e-3 m/s when friction sets in",
                       .variants = scalar_and_vector(),
                       .run = [scene](CaseRun& run) { run_released(run, scene); }});
    }
  }
  return cases;
}

}  // namespace stiction
