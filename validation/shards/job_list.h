// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reports/record/record.h"
#include "validation/core/runner.h"
#include "validation/shards/portion.h"

namespace stiction {

/// For other drivers, what --list --json prints: a JSON array with an object a job on a line of its own.
/// Fields: job (its place in the whole run, from 0), name, title, set ("quick", "default", "full"),
/// engine, configuration, settings, estimated_seconds (CPU time), needs (features of the manifest).
std::string job_list_json(const Portion& portion);

/// Prints what --lines says of a finished job, at once: a JSON object on one line. Fields: job, verdict, case, engine,
/// configuration, cpu_seconds, digits (of the least accurate check; null without one), state_hash,
/// error (empty unless it broke off).
void show_result_line(const Record& record);

}  // namespace stiction
