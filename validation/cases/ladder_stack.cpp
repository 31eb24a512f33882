// SPDX-License-Identifier: GPL-3.0-or-later
// Flush tiles on each other, up to forty.
#include <algorithm>
#include <cmath>

#include "validation/problems/ladder_problem.h"
#include "validation/stability/ladder.h"

namespace stiction {

namespace {

void run_stack(CaseRun& run, double tiles) {
  LadderBox tile;
  tile.size = Vec3(0.2, 0.2, 0.05);
  tile.elasticity = {.youngs_modulus = 1e8, .poisson_ratio = 0.3, .damping_time = 1e-4};
  std::vector<LadderBox> boxes = box_on_slab(tile, tile);
  for (int k = 2; k <= static_cast<int>(tiles); ++k) {
    LadderBox next = boxes.back();
    next.position.z() += tile.size.z();
    boxes.push_back(next);
  }
  // As in stack_problem.h: the slowest sway nearly critically damped.
  const double height = tiles * tile.size.z();
  const double wave = std::sqrt(tile.elasticity.youngs_modulus / (12.0 * tile.density));
  const double sway = 3.516 * wave * tile.size.x() / (height * height);
  const double drag = std::min(60.0, 1.5 * sway);
  check_ladder_rest(run, ladder_problem(boxes, 0.5, 0.02, drag),
                    "tiles rest on each other, however many");
}

}  // namespace

std::vector<Case> cases_ladder_stack() {
  std::vector<Case> all;
  append(all, {.name = "stack",
               .parameter = "tiles",
               .words = "so many flush tiles rest on each other",
               .rungs = {2, 5, 10, 20, 40},
               .run = run_stack});
  return all;
}

}  // namespace stiction
