// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engines/stiction/solver_engine.h"
#include "validation/engines/stiction/stiction_expectations.h"
#include "validation/engines/stiction/studies.h"

namespace stiction {

EngineKind engine_stiction() {
  EngineKind kind = solver_engine();
  kind.expectations = stiction_expectations();
  kind.studies = stiction_studies;
  return kind;
}

}  // namespace stiction
