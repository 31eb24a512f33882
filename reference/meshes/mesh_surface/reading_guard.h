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

/// What ends this process instead of a library that reads a file, each with the sentence on stderr.
struct ReadingLimits {
  int code = 1;           ///< exit code, of both
  std::string fallen{};   ///< said when the library falls over
  std::string late{};     ///< said after `seconds`
  double seconds = 60.0;  ///< > 0
  std::uint64_t bytes =
      0;  ///< of the file: memory beyond what such a file can need is std::bad_alloc
};

/// While it lives, a library may fall over what a file holds, or read it for ever. One at a time.
class ReadingGuard {
 public:
  explicit ReadingGuard(const ReadingLimits& limits);
  ~ReadingGuard();
  ReadingGuard(const ReadingGuard&) = delete;
  ReadingGuard& operator=(const ReadingGuard&) = delete;
};

}  // namespace stiction::reference
