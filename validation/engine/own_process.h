// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

namespace stiction {

/// What an engine that is a process of its own tells besides (held_memory.h asks by dynamic_cast).
class OwnProcess {
 public:
  virtual ~OwnProcess() = default;

  /// Its resident set, bytes, by the operating system; none where there is none to be read.
  virtual std::optional<std::int64_t> resident_memory() const = 0;
};

}  // namespace stiction
