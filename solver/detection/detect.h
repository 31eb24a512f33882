// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/contact/contacts.h"
#include "solver/scene/scene.h"
#include "solver/state.h"
#include "solver/workspace.h"

namespace stiction {

/// Finds the vertices whose predicted position x* = x_t0 + Δt v* lies inside a half-space, with
/// their depth d = −(x* − point)·n. Order: by obstacle, then by vertex. Only surface vertices that
/// can move are tested.
/// An obstacle with a motion is where it will be at the end of the step that starts at `time`, s.
/// Where `bounds` has the boxes of this step's bodies, those that are clear of the half-space are passed over.
/// The threads of a team look at ranges of vertices, and find the same.
void detect(const Scene& scene, double dt, const std::vector<Position>& position,
            const std::vector<Velocity>& predicted, OneSidedContacts& contacts, double time = 0.0,
            const PairSearch* bounds = nullptr, const Team* team = nullptr);

}  // namespace stiction
