// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace stiction::reference {

/// Bytes of address space that this process may have at most.
inline constexpr std::uint64_t kMostMemory = std::uint64_t{4} << 30;

/// Limits the address space of this process to kMostMemory from now on; more is std::bad_alloc. Not
/// under a sanitizer, which takes more than that for itself.
void limit_memory();

/// While it lives, a library may fall over what a file of `bytes` holds: a crash ends this process with
/// exit code `code` and `sentence` on stderr, and so does reading for longer than a minute; memory
/// beyond what such a file can need is std::bad_alloc. One at a time.
class ReadingGuard {
 public:
  ReadingGuard(int code, const std::string& sentence, std::uint64_t bytes);
  ~ReadingGuard();
  ReadingGuard(const ReadingGuard&) = delete;
  ReadingGuard& operator=(const ReadingGuard&) = delete;
};

}  // namespace stiction::reference
