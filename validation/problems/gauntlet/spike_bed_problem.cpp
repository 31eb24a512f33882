// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/gauntlet/spike_bed_problem.h"

#include <fmt/format.h>

#include "reference/meshes/box_mesh.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

Problem spike_bed_problem(const SpikeBedSetup& setup) {
  constexpr double kBlock = 0.02;  // m
  const double lowest = kBedHeight + setup.drop;
  const Vec3 place(setup.shift.x(), setup.shift.y(), lowest);
  Problem problem;
  problem.name = "bed of spikes";
  if (setup.spikes) {
    TetMesh mesh = spike_bed_mesh(
        {.pads_x = 2, .pads_y = 2, .pad = kBedPad, .height = -setup.height, .block = kBlock});
    mesh.vertices.row(2).array() += setup.height;
    problem.bodies = {gauntlet_body("spikes", std::move(mesh), place, yawed(setup.yaw))};
  } else {
    const Vec3 size(0.08, 0.08, kBlock);
    problem.bodies = {gauntlet_body("box", reference::box_mesh(size, {4, 4, 1}),
                                    place + Vec3(0.0, 0.0, 0.5 * size.z()), yawed(setup.yaw))};
  }
  problem.bodies.push_back(held_gauntlet_body(
      "bed",
      spike_bed_mesh(
          {.pads_x = 4, .pads_y = 3, .pad = kBedPad, .height = kBedHeight, .block = kBlock}),
      -kBlock, Vec3::Zero()));
  problem.friction = setup.friction;
  problem.gravity = {{0.0, 0.4}, {Vec3::Zero(), Vec3(0.0, 0.0, -kStandardGravity)}};
  problem.drag = setup.drag;
  return problem;
}

std::string spike_bed_words(const SpikeBedSetup& setup) {
  return fmt::format("{}, shifted by ({:.0f}, {:.0f}) mm, turned by {:.0f}°",
                     setup.spikes ? fmt::format("spikes of {:.0f} mm", 1e3 * setup.height) : "box",
                     1e3 * setup.shift.x(), 1e3 * setup.shift.y(), setup.yaw);
}

}  // namespace stiction
