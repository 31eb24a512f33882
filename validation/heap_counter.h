// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/observe/held_memory.h"

namespace stiction {

/// Counts the heap of a program that links heap_counter.cpp, which puts itself in front of malloc;
/// null where a sanitizer has done so already.
HeapCount heap_counter();

}  // namespace stiction
