// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/scene/scene.h"

namespace stiction {

/// Throws InputError with one sentence that names the body or obstacle, the index and the value.
void check_description(const SceneDescription& description);

/// Throws InputError when a vertex starts inside an obstacle: the contact force would close the
/// whole depth within one step and shoot the body off.
void check_start(const Scene& scene, double rounding = 0.0);

}  // namespace stiction
