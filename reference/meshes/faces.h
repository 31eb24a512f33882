// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace stiction::reference {

/// Corners of face k of a positively oriented tetrahedron, which lies opposite to corner k, as they are seen
/// from outside.
inline constexpr std::array<std::array<int, 3>, 4> kFaces = {
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

}  // namespace stiction::reference
