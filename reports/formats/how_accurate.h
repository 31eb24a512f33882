// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "reports/screen/screen.h"
#include "reports/text/standing.h"

namespace stiction {

/// The part of the summary screen about the configuration that holds most: `most` of the figures with
/// a headline, worst first, and the passing check that is nearest to failing. Empty without either.
std::string how_accurate(const Standings& standings, std::size_t most, const Screen& screen);

}  // namespace stiction
