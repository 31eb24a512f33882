// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engine/serve/serve.h"
#include "validation/engines/stiction/configurations.h"
#include "validation/engines/stiction/solver_engine.h"

int main(int argc, char** argv) {
  stiction::EngineKind kind = stiction::solver_engine();
  kind.name = "stiction_wide";
  kind.description = "this project's solver for vectors of 256 bits (AVX2)";
  return stiction::serve_engine(kind, stiction::method_configurations(), argc, argv);
}
