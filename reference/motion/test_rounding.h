// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

/// For the tests of this folder.
namespace stiction::reference {

inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

}  // namespace stiction::reference
