// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "validation/engine/engine.h"
#include "validation/engine/protocol/dialogue.h"
#include "validation/engine/protocol/program_words.h"

namespace stiction {

/// Starts the program, asks what it is and can, and ends it. Throws InputError in one sentence when
/// it cannot be started, or says what the protocol does not know.
EngineKind program_kind(const std::vector<std::string>& words, const ProgramLimits& limits);
/// The same of what answers in its place, in tests.
EngineKind program_kind(const std::vector<std::string>& words, const Answers& answers);

/// For all programs that are started from now on.
void set_program_limits(const ProgramLimits& limits);
ProgramLimits program_limits();

}  // namespace stiction
