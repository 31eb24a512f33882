// SPDX-License-Identifier: GPL-3.0-or-later
// What a smaller step buys: the drift of each method on a slab, at the default step and at smaller
// ones. Work and precision, a curve a method.
#include <vector>

#include "validation/engines/stiction/configurations.h"
#include "validation/protocols/slab_rest.h"

namespace stiction {

std::vector<Case> cases_slab_effort() {
  std::vector<Settings> variants;
  for (const Settings& method : compared_methods()) {
    variants.push_back(method);
    for (const char* const step : {"0.0001", "0.00005"}) {
      variants.push_back(method);
      variants.back()["dt"] = step;
    }
  }
  const SlabSetup setup = slab_at_20_degrees();
  return {{.name = "slab/effort",
           .title = "drift on a deformable slab at 20° over the cost of smaller steps",
           .variants = variants,
           .run = [setup](CaseRun& run) { check_slab_drift(run, setup); }}};
}

}  // namespace stiction
