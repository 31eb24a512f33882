// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/observe/held_memory.h"

#include <atomic>

#include "validation/engine/own_process.h"

namespace stiction {

namespace {

std::atomic<HeapCount> counter{nullptr};

}  // namespace

void set_heap_count(HeapCount count) { counter = count; }

std::optional<std::int64_t> held_memory(const Engine& engine) {
  if (const auto* const process = dynamic_cast<const OwnProcess*>(&engine)) {
    if (const auto resident = process->resident_memory()) return resident;
  }
  const HeapCount count = counter;
  return count ? std::optional(count()) : std::nullopt;
}

}  // namespace stiction
