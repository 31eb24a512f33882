// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "validation/engine/engine.h"

namespace stiction {

/// Serves an engine as a program behind the engine protocol (../protocol/README.md) until its input
/// ends: what it answers through the pipes is what it answers directly, to the last bit. It tells
/// the kind's ladder and these configurations, of which the first is the usual; what a kind knows of
/// single cases, its expectations and studies, has no place in the protocol. One problem and one kind a process.
/// Returns the exit code.
int serve_engine(const EngineKind& kind, const std::vector<Configuration>& configurations, int argc,
                 char** argv);

}  // namespace stiction
