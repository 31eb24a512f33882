// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solver/contact/pair_contacts.h"
#include "solver/parallel/team.h"
#include "solver/scene/scene.h"
#include "solver/state.h"

namespace stiction {

/// Keeps where the contacts are for the hysteresis and the ties of the next step: of those that it has
/// kept already, what has changed.
void remember_pairs(PairContacts& pairs, const Topology& topology, PairGeometry& memory,
                    const Team* team = nullptr);

}  // namespace stiction
