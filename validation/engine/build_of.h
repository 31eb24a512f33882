// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "validation/engine/engine.h"

namespace stiction {

/// Another build of an engine, by its name among EngineKind::builds. Throws NotApplicable, in words,
/// where the engine has none, or it was not built.
EngineKind build_of(const EngineKind& kind, const std::string& build);

}  // namespace stiction
