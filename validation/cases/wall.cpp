// SPDX-License-Identifier: GPL-3.0-or-later
// A wall of dry bricks in running bond, and stacks of bricks, on level ground.
#include <fmt/format.h>

#include <vector>

#include "validation/protocols/wall_rest.h"

namespace stiction {

std::vector<Case> cases_wall() {
  std::vector<Case> cases;
  WallSetup wall;
  wall.full = 0.3;
  wall.drag_ends = 0.9;  // bricks that rock in their joints are damped little by their strain
  const auto add = [&](const std::string& name, const std::string& title, CaseSet set,
                       const WallSetup& setup, double settled, double finer = 1.0) {
    cases.push_back({.name = name, .title = title, .set = set, .run = [=](CaseRun& run) {
                       check_wall(run, setup, settled, {.fineness = 1, .finer = finer});
                     }});
  };
  add("wall/running-bond", "a wall of five courses in running bond stands", CaseSet::kDefault, wall,
      1.0);
  add("wall/running-bond/doubled", "… in twice the window, with half the step", CaseSet::kFull,
      wall, 2.0, 2.0);
  WallSetup stack;
  stack.bricks = 1;
  stack.joint = 0.0;
  stack.edge = 0.1;
  // So stiff that twenty do not buckle by their own weight: H³ = 8 m³ < 7.84 E h²/(12 ρ g) = 27 m³.
  stack.elasticity = {.youngs_modulus = 4e7, .poisson_ratio = 0.0, .damping_time = 1.5e-4};
  for (const int boxes : {2, 5, 10, 20}) {
    stack.courses = boxes;
    // A high stack swings slowly up and down, at ¼√(E/ρ)/H, and is damped little.
    stack.full = 0.1 * boxes;
    const double settled = 1.0 + 0.2 * boxes;
    const std::string name = fmt::format("stack/rest/n={}", boxes);
    const std::string title = fmt::format("{} boxes stand on each other", boxes);
    add(name, title, boxes < 20 ? CaseSet::kDefault : CaseSet::kFull, stack, settled);
    add(name + "/doubled", title + ", in twice the window, with half the step", CaseSet::kFull,
        stack, 2.0 * settled, 2.0);
  }
  return cases;
}

}  // namespace stiction
