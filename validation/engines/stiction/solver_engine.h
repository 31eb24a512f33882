// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/engine/engine.h"

namespace stiction {

/// The solver as an engine, in the precision that it is compiled with (solver/real.h): without what
/// holds for one build of it alone, expectations and studies. engine_stiction() adds those of the
/// double-precision build; a program of its own serves another (../stiction_single/).
EngineKind solver_engine();

}  // namespace stiction
