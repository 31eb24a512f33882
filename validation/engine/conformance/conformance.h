// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "validation/engine/engine.h"

namespace stiction {

/// What trying an adapter against one known answer showed.
enum class Conformity {
  kHolds,
  kFails,
  kNotApplicable  ///< the engine's manifest lacks what it needs
};

struct Finding {
  std::string name;  ///< of the check, e.g. "free fall"
  Conformity conformity = Conformity::kHolds;
  std::string sentence;  ///< what was seen, with the number
};

/// Tries an engine's adapter against answers that no model of contact changes: free fall, a known
/// velocity, the sign of forces, units, the order of bodies, rotations, μ of each pair, the clock,
/// loads, saved states. In each of its configurations, with `settings` over them, until one holds: an
/// adapter is the same in all, and what a configuration does worse the cases measure. Throws nothing
/// for what the engine does.
std::vector<Finding> check_conformance(const EngineKind& kind, const Settings& settings);

/// Throws InputError with the first failure: no engine is graded that fails. Of a program alone.
void demand_conformance(const EngineKind& kind, const Settings& settings);

}  // namespace stiction
