// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <nlohmann/json.hpp>

#include "validation/engine/kit/stiction_engine.h"

namespace stiction::kit {

/// A problem with all that its pointers point to.
class OwnedProblem {
 public:
  virtual ~OwnedProblem() = default;
  virtual const stiction_problem& problem() const = 0;
};

/// Reads `problem` and `accuracy` of a `load` message. Throws std::exception with a sentence that
/// names the field.
std::unique_ptr<OwnedProblem> read_problem(const nlohmann::json& message);

}  // namespace stiction::kit
