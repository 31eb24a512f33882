// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace stiction {

/// What a user gave cannot be simulated: one clear sentence, raised while a scene, its options or a
/// saved state are checked, never from inside a step.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A condition that must hold in every build, optimised ones included. Raises std::logic_error.
inline void demand(bool holds, const char* what) {
  if (!holds) throw std::logic_error(std::string("stiction: demand broken: ") + what);
}

}  // namespace stiction
