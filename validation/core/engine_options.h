// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <vector>

#include "validation/engine/protocol/program_kind.h"

namespace stiction {

/// The options of every program that starts engines which are programs.
inline std::vector<CLI::Option*> add_engine_limits(CLI::App& app, ProgramLimits& limits) {
  return {app.add_option("--engine-seconds", limits.reply_seconds,
                         "An engine that is a program may take so long for an answer, s")
              ->type_name("S")
              ->capture_default_str(),
          app.add_option("--engine-memory", limits.memory_gib, "... and may hold so much data, GiB")
              ->type_name("GIB")
              ->capture_default_str()};
}

}  // namespace stiction
