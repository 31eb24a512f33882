// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "benchmarks/track/sizes/sizes.h"
#include "reports/record/record.h"
#include "reports/screen/screen.h"

namespace stiction::track {

/// What was measured of one family, as a record "sizes/slab": the cost of whole steps and of phases over the
/// contacts, before and now, in narrower registers, of threads, and what the machine allows. Checks that all
/// was at rest, and that widths and threads leave the same state.
Record family_record(const std::vector<SizeResult>& results, const Tree& before,
                     const Environment& environment);

/// What was found, on a screen: by how much whole steps are faster, then a line each workload.
std::string size_summary(const std::vector<SizeResult>& results, const Tree& before,
                         const Tree& now, const Screen& screen);

}  // namespace stiction::track
