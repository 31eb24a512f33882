// SPDX-License-Identifier: GPL-3.0-or-later
// Every rule on every scene: how many steps it takes to find static friction that was lost.
#include "validation/comparison/comparison.h"
#include "validation/comparison/rule_history.h"

namespace stiction {

std::vector<Case> comparisons_rules() {
  std::vector<Case> cases;
  for (const ComparisonScene& scene : comparison_scenes()) {
    cases.push_back({.name = "rules/" + scene.name,
                     .title = scene.title,
                     .set = scene.quick ? CaseSet::kQuick : CaseSet::kDefault,
                     .variants = all_rules(),
                     .run = [scene](CaseRun& run) { report_history(run, run_rule(run, scene)); }});
  }
  return cases;
}

}  // namespace stiction
