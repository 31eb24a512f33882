// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace stiction::bench {

/// Heap allocations through operator new since the program began. The program that links this file
/// has its operator new replaced by one that counts.
std::uint64_t allocations();

}  // namespace stiction::bench
