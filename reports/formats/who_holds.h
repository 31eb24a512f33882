// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reports/screen/screen.h"
#include "reports/text/standing.h"

namespace stiction {

/// The part of the summary screen that sets configurations side by side: what they hold, at which
/// cost, and how things rest. Empty without records.
std::string who_holds(const Standings& standings, const Screen& screen);

}  // namespace stiction
