// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "benchmarks/track/sizes/sizes.h"
#include "reports/record/record.h"
#include "reports/screen/screen.h"

namespace stiction::track {

/// What was measured of one family, "sizes/slab": a record each way, as a configuration, with the cost of
/// whole steps over the contacts, before and now of phases too; and what the machine allows. Checks that all
/// was at rest, and that widths and threads leave the same state.
std::vector<Record> family_records(const std::vector<SizeResult>& results, const Tree& before,
                                   const Environment& environment);

/// What was found, on a screen: by how much whole steps are faster, then a line each workload.
std::string size_summary(const std::vector<SizeResult>& results, const Tree& before,
                         const Tree& now, const Screen& screen);

}  // namespace stiction::track
