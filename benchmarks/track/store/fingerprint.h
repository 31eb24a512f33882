// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "benchmarks/track/measure/tree.h"
#include "benchmarks/track/store/history.h"
#include "reports/record/record.h"

namespace stiction::track {

/// The machine of an environment: "Example CPU, 2 cores" and "GCC 12.2.0, Release …".
Machine machine_of(const Environment& environment);

/// What `bench --machine` of a built revision tells; nothing for a revision from before it.
std::optional<Machine> told_machine(const Tree& tree);

}  // namespace stiction::track
