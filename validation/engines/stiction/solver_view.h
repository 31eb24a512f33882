// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/options.h"
#include "solver/scene/scene.h"
#include "solver/workspace.h"
#include "validation/engine/engine.h"

namespace stiction {

/// What the studies of this engine see of its solver beyond what any engine shows. All references
/// live as long as the engine and are of its last step.
struct SolverView {
  const Scene& scene;
  const Options& options;
  const Workspace& workspace;
};

/// Of a loaded engine; NotApplicable when it is another, or that behind a wrapper.
SolverView solver_view(const Engine& engine);

}  // namespace stiction
