// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reference/process/child.h"

/// For the tests of this folder.
namespace stiction::test {

/// Where a program of this build is.
inline std::string program(const char* name) {
  return (reference::folder_of_this_program() / name).string();
}

}  // namespace stiction::test
