// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "solver/demand.h"

namespace stiction::test {

/// The sentence with which `action` refuses its input; empty when it accepts.
template <class Action>
std::string refusal(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace stiction::test
