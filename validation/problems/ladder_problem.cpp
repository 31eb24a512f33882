// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/ladder_problem.h"

#include <cmath>

#include "reference/meshes/box_mesh.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

ProblemBody ladder_body(const LadderBox& box, const std::string& name) {
  ProblemBody body;
  body.name = name;
  body.shape =
      MeshShape{reference::box_mesh(box.size, reference::box_cells(box.size, box.cells)), true};
  body.mass = box.density * box.size.prod();
  body.elasticity = box.elasticity;
  body.position = box.position;
  body.rotation = box.rotation;
  body.velocity = box.velocity;
  body.angular_velocity = box.angular_velocity;
  if (box.held) body.held = HeldPart{Vec3(0.0, 0.0, -0.5 * box.size.z()), Vec3::UnitZ()};
  return body;
}

Problem ladder_problem(const std::vector<LadderBox>& boxes, double friction, double tan_slope,
                       double drag) {
  Problem problem;
  problem.name = "ladder";
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    problem.bodies.push_back(ladder_body(boxes[k], k == 0 ? "ground" : "box " + std::to_string(k)));
  }
  problem.friction = friction;
  const double cosine = 1.0 / std::hypot(1.0, tan_slope);
  const Vec3 into(0.0, 0.0, -kStandardGravity * cosine);
  const Vec3 full = into + Vec3(kStandardGravity * cosine * tan_slope, 0.0, 0.0);
  problem.gravity = {{0.0, kLadderPressed, kLadderTilted}, {Vec3::Zero(), into, full}};
  problem.drag = {.rate = drag, .full_until = kLadderDragFull, .ends = kLadderDragEnds};
  problem.duration = kLadderSettled + kLadderWindow;
  return problem;
}

std::vector<LadderBox> box_on_slab(LadderBox box, LadderBox slab) {
  slab.held = true;
  slab.position = Vec3(0.0, 0.0, -0.5 * slab.size.z());
  box.position.z() += 0.5 * box.size.z();
  return {slab, box};
}

}  // namespace stiction
