// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <stdexcept>
#include <string>

namespace stiction::kit {

/// What stiction_lacks throws: the case is not applicable.
class Lacking : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Settings of the run as given, and as resolved: what load told of its parameters.
struct RunSettings {
  std::map<std::string, std::string> given{}, resolved{};
};

/// One engine a program, one problem a process.
RunSettings& told();

}  // namespace stiction::kit
