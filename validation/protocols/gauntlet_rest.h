// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "validation/observe/rest_watch.h"

namespace stiction {

/// What must rest: body 0 of each scene under its weight on the others.
struct GauntletRest {
  std::string claim;  ///< "a body hung from an edge rests"
  std::string source;
  double settled = 4.0;    ///< s
  double window = 1.0;     ///< s
  double given_up = 0.02;  ///< m: how far no centre goes while it settles
};

/// Simulates each scene, every other at half the engine's time step, and checks that none gives way,
/// that all rest, and that what the contacts say balances the weight: force and moment.
std::vector<RestOutcome> check_gauntlet_rest(
    CaseRun& run, const std::vector<std::pair<std::string, Problem>>& scenes,
    const GauntletRest& what);

/// Of the contacts on a body: their force, N, and moment about a point, N m.
struct Reaction {
  Vec3 force = Vec3::Zero();
  Vec3 moment = Vec3::Zero();
};
Reaction reaction_on(std::size_t body, const std::vector<ContactSample>& contacts,
                     const Vec3& about);

}  // namespace stiction
