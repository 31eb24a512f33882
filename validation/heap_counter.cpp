// SPDX-License-Identifier: GPL-3.0-or-later
// Every block of the heap is counted, below operator new: Eigen's dynamic matrices call malloc
// themselves. glibc lets a program put its own in front.
#include "validation/heap_counter.h"

#ifdef STICTION_SANITIZES_MEMORY

namespace stiction {

HeapCount heap_counter() { return nullptr; }

}  // namespace stiction

#else

#include <malloc.h>

#include <cerrno>
#include <cstddef>

namespace {

thread_local std::int64_t held = 0;  // bytes

std::int64_t size_of(void* block) noexcept {
  return static_cast<std::int64_t>(malloc_usable_size(block));
}

void* taken(void* block) noexcept {
  held += size_of(block);
  return block;
}

}  // namespace

extern "C" {

void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);

void* malloc(std::size_t size) noexcept { return taken(__libc_malloc(size)); }
void* calloc(std::size_t count, std::size_t size) noexcept {
  return taken(__libc_calloc(count, size));
}
void* realloc(void* block, std::size_t size) noexcept {
  const std::int64_t before = size_of(block);
  void* const moved = __libc_realloc(block, size);
  if (moved != nullptr || size == 0) held += size_of(moved) - before;
  return moved;
}
void* memalign(std::size_t alignment, std::size_t size) noexcept {
  return taken(__libc_memalign(alignment, size));
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return memalign(alignment, size);
}
int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept {
  void* const found = memalign(alignment, size);
  if (found == nullptr) return ENOMEM;
  *block = found;
  return 0;
}
void free(void* block) noexcept {
  held -= size_of(block);
  __libc_free(block);
}

}  // extern "C"

namespace stiction {

HeapCount heap_counter() {
  return [] { return held; };
}

}  // namespace stiction

#endif
