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

/// What ends this process instead of a library that reads or computes with what a file holds, each with
/// its sentence on stderr.
struct LibraryLimits {
  int code = 1;          ///< exit code, of both
  std::string fallen{};  ///< said when the library falls over
  std::string late{};    ///< said after `seconds`
  double seconds = 0.0;  ///< 0: as long as it takes
  /// Memory beyond what reading a file of so many bytes can need is std::bad_alloc.
  std::uint64_t bytes = kMostMemory;
};

/// While it lives, a library may fall over, or take for ever. One at a time.
class LibraryGuard {
 public:
  explicit LibraryGuard(const LibraryLimits& limits);
  ~LibraryGuard();
  LibraryGuard(const LibraryGuard&) = delete;
  LibraryGuard& operator=(const LibraryGuard&) = delete;
};

}  // namespace stiction::reference
