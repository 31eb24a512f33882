// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <dart/collision/CollisionFilter.hpp>
#include <dart/simulation/World.hpp>

#include "validation/engine/kit/stiction_engine.h"

namespace stiction_dart {

/// A world with the time step, collision detector, solver and contact parameters that the settings
/// of this run ask for, else as DART makes it; all of them are told.
dart::simulation::WorldPtr make_world(const stiction_problem& problem);

/// Lets a shape named "on obstacles" touch obstacles alone, one named "on bodies" bodies alone.
///
/// Of two shapes that touch, DART takes the smaller μ. So where μ with an obstacle is above that
/// between bodies, each body has two shapes of the same size.
class TwoShapes final : public dart::collision::BodyNodeCollisionFilter {
 public:
  bool ignoresCollision(const dart::collision::CollisionObject* one,
                        const dart::collision::CollisionObject* other) const override;
};

}  // namespace stiction_dart
