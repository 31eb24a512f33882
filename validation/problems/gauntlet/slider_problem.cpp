// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/problems/gauntlet/slider_problem.h"

#include <fmt/format.h>

#include "reference/meshes/box_mesh.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {

namespace {

constexpr double kTip = 0.015;  // height of spikes and ridges, m

// Its lowest points at z = 0.
TetMesh mesh_of(Slider slider) {
  if (slider == Slider::kBox) {
    const Vec3 size(0.06, 0.06, 0.03);
    TetMesh mesh = reference::box_mesh(size, {4, 4, 2});
    mesh.vertices.row(2).array() += 0.5 * size.z();
    return mesh;
  }
  TetMesh mesh;
  if (slider == Slider::kSpikes) {
    mesh = spike_bed_mesh({.pads_x = 2, .pads_y = 2, .pad = 0.04, .height = -kTip});
  } else {
    mesh = ridged_mesh({.height = -kTip});
  }
  mesh.vertices.row(2).array() += kTip;
  return mesh;
}

}  // namespace

Problem slider_problem(const SliderSetup& setup) {
  constexpr int kCells = 15;
  const Slid path = slid(setup, setup.duration);
  Problem problem;
  problem.name = "slide over inner edges";
  problem.bodies = {
      gauntlet_body("slider", mesh_of(setup.slider), Vec3(-0.5 * path.distance, 0.0, 0.0)),
      held_gauntlet_body("flat", flat_mesh(kCells * kFlatCell, kFlatCell, kCells, setup.irregular),
                         1.0, Vec3::Zero(), yawed(setup.azimuth))};
  problem.bodies[0].velocity = Vec3(setup.speed, 0.0, 0.0);
  problem.friction = setup.friction;
  problem.gravity = {{0.0, setup.ramp}, {Vec3::Zero(), Vec3(0.0, 0.0, -kStandardGravity)}};
  problem.duration = setup.duration;
  return problem;
}

Slid slid(const SliderSetup& setup, double time) {
  const double ramp = setup.ramp, after = time - ramp;
  const double braked = setup.friction * kStandardGravity;
  return {
      setup.speed * time - braked * (ramp * ramp / 7.0 + 0.5 * ramp * after + 0.5 * after * after),
      setup.speed - braked * (0.5 * ramp + after)};
}

double load_ratio(const SliderSetup& setup) {
  const TetMesh mesh = mesh_of(setup.slider);
  double all = 0.0, lowest = 0.0;
  for (Eigen::Index e = 0; e < mesh.tetrahedra.cols(); ++e) {
    const double share = 0.25 * signed_volume(mesh, e);
    all += 4.0 * share;
    for (const int v : mesh.tetrahedra.col(e)) {
      if (mesh.vertices(2, v) < 1e-9) lowest += share;
    }
  }
  return all / lowest;
}

std::string slider_words(const SliderSetup& setup) {
  const char* const sliders[] = {"box", "spikes", "ridges"};
  return fmt::format("{}, mesh{} at {:.0f}°", sliders[static_cast<int>(setup.slider)],
                     setup.irregular ? " irregular," : "", setup.azimuth);
}

}  // namespace stiction
