// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace stiction {

/// In large scenes what a contact reads lies far apart and out of the cache: it's asked for so many
/// contacts before it is read, and what that tells to read half as many before. At 1e5 contacts that
/// more than halves the time of detection and depth. With half of this, normal force and friction took
/// 1.1 to 1.2 times as long there, within a step; with twice as much as long.
inline constexpr std::size_t kAskedAhead = 32;

/// Up to which of so many contacts others are asked for: all that a step reads of few, some 500
/// bytes each, stays in a second-level cache, and to ask would only take instructions.
constexpr std::size_t asks_until(std::size_t contacts) {
  constexpr std::size_t kFarApart = 1536;
  return contacts < kFarApart ? 0 : contacts - kAskedAhead;
}

/// Whether those of so many contacts lie so far apart that what is read of their vertices doesn't stay in a
/// second-level cache either: the records alone have 2 MiB.
constexpr bool lie_far_apart(std::size_t contacts) { return contacts >= 16384; }

/// Asks for the memory that an object begins in, and waits for nothing.
inline void ask_for(const void* object) {
  __builtin_prefetch(object);
  // Else GCC takes a function that only asks for one without effect, and drops its calls.
  asm volatile("");
}

}  // namespace stiction
