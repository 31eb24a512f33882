// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "validation/engine/engine.h"

namespace stiction {

/// Bytes of the heap that this thread has taken and not given back.
using HeapCount = std::int64_t (*)();

/// Only a program can count its heap (heap_counter.h). Null, the default: nobody does.
void set_heap_count(HeapCount count);

/// Bytes that the engine holds, to be compared with those at another time: the resident set of its
/// process, or, of an engine of this program, the heap of this thread, of which what the case keeps
/// meanwhile is a part. None where nobody counts.
std::optional<std::int64_t> held_memory(const Engine& engine);

}  // namespace stiction
