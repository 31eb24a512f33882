// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace stiction::kit {

/// The setting that every engine of the kit has, and what --help says of it.
inline constexpr const char* kRounding = "rounding";
inline constexpr const char* kRoundingHelp =
    "how the engine's arithmetic rounds: nearest, upward, downward, toward-zero (nearest)";

inline constexpr const char* kNearest = "nearest";

/// The mode of fesetround of that word. Throws std::runtime_error that lists the words.
int rounding_mode(const std::string& word);

/// While it lives, this thread rounds so.
class Rounds {
 public:
  explicit Rounds(int mode);
  ~Rounds();
  Rounds(const Rounds&) = delete;
  Rounds& operator=(const Rounds&) = delete;

 private:
  int before_;
};

}  // namespace stiction::kit
