// SPDX-License-Identifier: GPL-3.0-or-later
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
