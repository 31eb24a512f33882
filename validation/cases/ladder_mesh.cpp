// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes as no mesher should make them: flat and thin tetrahedra, and more contacts than say anything new.
#include <cmath>

#include "reference/meshes/box_mesh.h"
#include "validation/observe/observe.h"
#include "validation/problems/ladder_problem.h"
#include "validation/problems/slopes/incline_problem.h"
#include "validation/stability/ladder.h"

namespace stiction {

namespace {

// A body thrown in free fall. Its mesh makes no difference to that, and a thin element's forces are
// round-off times its stiffness.
void check_fall(CaseRun& run, const TetMesh& mesh) {
  Problem problem;
  problem.name = "thrown body";
  problem.bodies = {ladder_body({}, "body")};
  problem.bodies[0].shape = MeshShape{mesh};
  problem.bodies[0].velocity = Vec3(0.3, -0.2, 1.0);
  problem.bodies[0].must_deform = true;
  problem.gravity = {{0.0}, {Vec3(0.0, 0.0, -kStandardGravity)}};
  constexpr std::uint64_t kSteps = 5000;
  const auto simulation = run.simulate(problem);
  const Vec3 start = simulation->engine().body(0).velocity;
  simulation->advance(kSteps);
  const Engine& engine = simulation->engine();
  const double time = simulation->time();
  const Vec3 expected = start + time * Vec3(0.0, 0.0, -kStandardGravity);
  run.check(
      {.quantity = "velocity after 5000 steps",
       .unit = "m/s",
       .statement = "a body falls as it must, whatever its mesh",
       .formula = "|v − (v₀ + g t)| = 0",
       .source = "Newton's second law",
       .kind = ReferenceKind::kAnalytic,
       .expected = 0.0,
       .scale = start.norm(),
       .tolerance = 5000 * 1.1e-16 * 8.0,
       .reason = "a rounding a step and axis, of 1 m/s, twice in the force of an element; inner "
                 "forces cancel but for their round-off"},
      (engine.body(0).velocity - expected).norm());
  const double kinetic = 0.5 * problem.bodies[0].mass * start.squaredNorm();
  run.check(
      {.quantity = "elastic energy over kinetic energy",
       .unit = "1",
       .statement = "… and stays what it is, undeformed",
       .formula = "E/K = 0",
       .source = "nothing deforms a body in free fall",
       .kind = ReferenceKind::kAnalytic,
       .expected = 0.0,
       .scale = 1.0,
       .tolerance = 1e-12,
       .reason = "strains of round-off, 1e-16 over the thinnest share of an edge, squared: ½ E ε² "
                 "V of 5 kJ ε² stays below 1e-12 of the kinetic energy down to a thinness of 1e-8"},
      engine.energies().elastic / kinetic);
  const Eigen::AngleAxisd turn(engine.body(0).rotation);
  run.check(
      {.quantity = "turn",
       .unit = "rad",
       .statement = "… and does not turn",
       .formula = "φ = 0",
       .source = "Euler's law",
       .kind = ReferenceKind::kAnalytic,
       .expected = 0.0,
       .scale = 1.0,
       .tolerance = 1e-9,
       .reason = "round-off of the fitted rotation, 1e-16 of vertices a tenth of a metre apart, "
                 "over 5000 steps in which each may turn the last bits"},
      turn.angle());
}

TetMesh cube() { return reference::box_mesh(Vec3::Constant(0.1), Eigen::Vector3i::Constant(2)); }

Eigen::Index inner_vertex(const TetMesh& mesh) {
  Eigen::Index inner = 0;
  mesh.vertices.colwise().norm().minCoeff(&inner);
  return inner;
}

// The middle vertex moved towards a face, where its tetrahedra become flat: slivers.
void run_sliver(CaseRun& run, double thinness) {
  TetMesh mesh = cube();
  mesh.vertices.col(inner_vertex(mesh)).z() = 0.05 * (1.0 - thinness);
  check_fall(run, mesh);
}

// A rod of one cell, as thin: its tetrahedra are needles.
void run_needle(CaseRun& run, double thinness) {
  constexpr double kLength = 0.1;  // m
  check_fall(run,
             reference::box_mesh(kLength * Vec3(1.0, thinness, thinness), Eigen::Vector3i::Ones()));
}

// A slab of so many cells an edge under a box of as many: each says of the same plane what the others say.
void run_contacts(CaseRun& run, double cells) {
  LadderBox box, slab;
  for (LadderBox* one : {&box, &slab}) {
    one->elasticity = {.youngs_modulus = 2e5, .poisson_ratio = 0.3, .damping_time = 2e-3};
    one->cells = static_cast<int>(cells);
  }
  box.size = Vec3(0.1, 0.1, 0.1 / cells);
  slab.size = Vec3(0.11, 0.11, 0.11 / cells);
  box.position = Vec3(0.001, 0.002, 0.0);
  check_ladder_rest(run, ladder_problem(box_on_slab(box, slab), 0.5, 0.3),
                    "a plate rests on as many contacts as one likes");
}

}  // namespace

std::vector<Case> cases_ladder_mesh() {
  std::vector<Case> all;
  append(all, {.name = "sliver",
               .parameter = "thinness",
               .words = "a cube of tetrahedra so flat falls as it must",
               .rungs = {1, 1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8},
               .run = run_sliver});
  append(all, {.name = "needle",
               .parameter = "thinness",
               .words = "a rod so thin for its length falls as it must",
               .rungs = {1, 1e-1, 1e-2, 1e-3, 1e-4, 1e-6},
               .run = run_needle});
  append(all, {.name = "contacts",
               .parameter = "cells",
               .words = "a plate of so many cells an edge rests on another",
               .rungs = {1, 2, 4, 8, 16},
               .only_full = 1,
               .run = run_contacts});
  return all;
}

}  // namespace stiction
