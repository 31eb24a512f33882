// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "solver/depth/walk_scratch.h"
#include "solver/mesh/mesh_links.h"

namespace stiction {

/// Scratch memory of consistent depths; empty until they are first asked for.
struct ConsistentScratch {
  MeshLinks links;
  WalkScratch walk;
  std::vector<int> level;  ///< per contact: 0 not reached, 1 border, 2 … propagated
  std::vector<std::int32_t> first_contact;  ///< per vertex, −1 for none; all −1 between steps
  std::vector<std::int32_t> front, next;    ///< contacts of the last level and of the one in work
};

}  // namespace stiction
