// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reports/record/record.h"
#include "validation/engine/engine.h"

namespace stiction {

/// The rows of an engine's table beside what the records of a run measured, each as the table's
/// source spells it, so that a band is renewed by copying a line: rows that hold the value, rows
/// that don't with a band that would, rows whose check meets its claim now or is gone, and checks
/// that fail without a row. A proposed band is a factor of three about what was measured; whether
/// that is right, and what the cause is, is for a person to find out.
std::string show_expectations(const std::vector<Record>& records, const EngineKind& engine);

}  // namespace stiction
