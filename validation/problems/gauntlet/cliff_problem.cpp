// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/gauntlet/cliff_problem.h"

#include <fmt/format.h>

#include "reference/meshes/box_mesh.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

Problem cliff_problem(const CliffSetup& setup) {
  const Vec3 support(0.12, 0.14, 0.04);
  Problem problem;
  problem.name = "cliff edge";
  problem.bodies = {
      gauntlet_body("box", reference::box_mesh(setup.size, {5, 3, 2}),
                    Vec3(-setup.inside, 0.0, 0.5 * setup.size.z()), yawed(setup.yaw)),
      held_gauntlet_body("support", reference::box_mesh(support, {3, 4, 1}), -0.5 * support.z(),
                         Vec3(-0.5 * support.x(), 0.0, -0.5 * support.z()))};
  problem.friction = setup.friction;
  problem.gravity = {{0.0, 0.4}, {Vec3::Zero(), Vec3(0.0, 0.0, -kStandardGravity)}};
  problem.drag = setup.drag;
  return problem;
}

std::string cliff_words(const CliffSetup& setup) {
  return fmt::format("turned by {:.0f}°, centre {:.0f} mm {} the edge", setup.yaw,
                     1e3 * std::abs(setup.inside), setup.inside > 0.0 ? "inside" : "beyond");
}

}  // namespace stiction
