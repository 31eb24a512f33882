// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engine/engine.h"

#include "solver/demand.h"

namespace stiction {

EngineKind find_engine(const std::string& name) {
  std::string known;
  for (const EngineKind& kind : engine_catalog()) {
    if (kind.name == name) return kind;
    known += (known.empty() ? "" : ", ") + kind.name;
  }
  throw InputError("unknown engine '" + name + "'; there are: " + known);
}

}  // namespace stiction
