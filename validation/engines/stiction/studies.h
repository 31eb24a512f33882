// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "validation/core/case.h"

namespace stiction {

/// Cases that study this project's solver: they name its settings, look into it, or hold it against
/// a reference that no other engine could be held against. Written by the build from cases/.
std::vector<Case> stiction_studies();

}  // namespace stiction
