// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/judge/expectation.h"

/// For the tests of this folder.
namespace stiction::test {

inline constexpr Cause kCause{"kCause", "a cause", "in short"};
inline constexpr Words kWidth{"kWidth", "a width"};

}  // namespace stiction::test
