// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "validation/engine/problem.h"

namespace stiction {

/// Whether bodies begin inside each other or in an obstacle, told in words with names and depth;
/// empty: none does, or what does is held on both sides. Of the shapes themselves, not of what an
/// engine makes of them; exact but for the rounding of where they are put.
std::string overlap_at_start(const Problem& problem);

}  // namespace stiction
