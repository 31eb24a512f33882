// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "validation/engine/kit/stiction_engine.h"

namespace stiction::kit {

/// What an engine's program answers, line by line.
class Session {
 public:
  explicit Session(const stiction_engine& engine);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// The answer to a line of the protocol, without its line break: whatever the line is.
  std::string reply(const std::string& line);
  /// `quit` has come.
  bool over() const { return over_; }

 private:
  class Dealings;
  std::unique_ptr<Dealings> dealings_;
  bool over_ = false;
};

}  // namespace stiction::kit
