// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "benchmarks/bench/batch.h"

namespace stiction::bench {

/// What a batch must do at least.
struct ModelledCost {
  double bytes = 0.0;  ///< of each record that it reads and of each that it writes, once
  double flops =
      0.0;  ///< additions, multiplications, divisions and roots of the formulas, each one
};

/// The cost model: records touched × their size, and the arithmetic of the formulas, of a part of
/// the step on a workload as it is at rest. Where a search tests more than it finds (detect, depth)
/// only what is found counts, so the fraction of the machine's peak shows what the search costs.
ModelledCost modelled_cost(const Timed& timed, const Workload& work);

}  // namespace stiction::bench
