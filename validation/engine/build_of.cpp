// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engine/build_of.h"

#include "solver/demand.h"

namespace stiction {

EngineKind build_of(const EngineKind& kind, const std::string& build) {
  const auto found = kind.builds.find(build);
  if (found == kind.builds.end()) throw NotApplicable("the engine has no such build");
  try {
    return find_engine(found->second);
  } catch (const InputError& error) {
    throw NotApplicable(error.what());  // not built, mostly
  }
}

}  // namespace stiction
