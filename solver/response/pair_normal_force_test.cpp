// SPDX-License-Identifier: BSD-3-Clause
#include "solver/response/pair_normal_force.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "solver/testing/test_pairs.h"

namespace stiction {
namespace {

Options paper() {
  Options options;
  options.pairs.gain = NormalGain::kPaper;
  options.pairs.weights = PairWeights::kTriangle;
  return options;
}

// How far a step closes each depth per unit depth of each contact: K = Δt² ∂(closing)/∂d.
Eigen::MatrixXd closing(const Scene& scene, const Options& options, test::Found found) {
  PairContacts& pairs = found.workspace.pairs;
  const auto count = static_cast<Eigen::Index>(pairs.size());
  Eigen::MatrixXd k(count, count);
  // The same for all: a vertex that only just touches has none of its own to scale.
  for (PairContact& contact : pairs) contact.depth = 1e-3;
  pair_normal_forces(scene, options, found.workspace);
  for (Eigen::Index source = 0; source < count; ++source) {
    // Only this contact's force, per unit of its depth.
    for (Velocity& v : found.workspace.velocity) v.v.setZero();
    PairContact one = pairs[static_cast<std::size_t>(source)];
    one.normal_force /= one.depth;
    apply_normal_force(options, one, found.workspace.velocity);
    for (Eigen::Index c = 0; c < count; ++c) {
      const PairContact& contact = pairs[static_cast<std::size_t>(c)];
      Vec3 v = found.workspace.velocity[static_cast<std::size_t>(contact.vertex)].v;
      for (int j = 0; j < 4; ++j) {
        v -= contact.weight[j] *
             found.workspace.velocity[static_cast<std::size_t>(contact.partner[j])].v;
      }
      k(c, source) = options.time_step * contact.normal.dot(v);
    }
  }
  return k;
}

double largest_kappa(const Scene& scene, const Options& options) {
  const test::Found found(scene, options, initial_state(scene));
  EXPECT_GT(found.workspace.pairs.size(), 8u);
  return closing(scene, options, found).eigenvalues().real().maxCoeff();
}

TEST(PairNormalForce, HarmonicGainClosesAtMostKappaOfAnyCombinationOfDepths) {
  for (const double kappa : {0.5, 1.0}) {
    for (const PairWeights weights : {PairWeights::kTriangle, PairWeights::kTetrahedron}) {
      Options options;
      options.pairs.harmonic_gain = kappa;
      options.pairs.weights = weights;
      for (const double shift : {0.0, 0.1, 0.21, 0.33}) {
        const Scene scene = build_scene(test::stacked_cubes(0.02, Vec3(shift, 0.4 * shift, 0)));
        EXPECT_LE(largest_kappa(scene, options), kappa * (1.0 + 1e-12));
      }
    }
  }
}

// An isolated vertex on a triangle of equal masses, h = ⅓: c_i = 1, c_j = 1/(1 + ⅓) = ¾, M = ¾ m,
// γ = ¾/(1 + ¾) = 3/7; transmitted ½ · 3/7 m d/Δt², closing κ = 3/14 (1 + ⅓) = 2/7.
TEST(PairNormalForce, HarmonicGainCountsTheVertexsContactsWithObstacles) {
  const Scene scene = build_scene(test::stacked_cubes(0.02));
  const Options options;
  test::Found found(scene, options, initial_state(scene));
  PairContact& first = found.workspace.pairs.front();
  first.depth = 1e-3;
  pair_normal_forces(scene, options, found.workspace);
  const double alone = found.workspace.pairs.front().normal_force;
  const auto v = static_cast<std::size_t>(first.vertex);
  found.workspace.contacts.add(contact_key(0, first.vertex), first.vertex, 0, 1e-3);
  pair_normal_forces(scene, options, found.workspace);
  // 1/fⁿ is a sum over the vertices of N/m: one more contact adds 1/m.
  const double dt = options.time_step;
  EXPECT_NEAR(
      first.depth / (dt * dt) * (1.0 / found.workspace.pairs.front().normal_force - 1.0 / alone),
      1.0 / scene.mass[v], 1e-12 / scene.mass[v]);
}

TEST(PairNormalForce, OfAnIsolatedPairOfEqualMassesIsThePapersWithTwoSeventhsClosed) {
  Scene scene;
  scene.mass = {1, 1, 1, 1};
  Workspace workspace;
  workspace.velocity.assign(4, {Vec3::Zero(), 1.0});
  PairContact contact;
  contact.vertex = 0;
  const double third = 1.0 / 3.0;
  for (int k = 0; k < 3; ++k) {
    contact.partner[k] = k + 1;
    contact.weight[k] = third;
  }
  contact.partner[3] = 3;
  contact.normal = Vec3::UnitZ();
  contact.depth = 1e-3;
  workspace.pairs.resize(1);
  workspace.pairs.front() = contact;
  const Options options = paper();
  const double dt = options.time_step;
  pair_normal_forces(scene, options, workspace);
  EXPECT_NEAR(workspace.pairs[0].normal_force, 0.5 * 3.0 / 7.0 * 1e-3 / (dt * dt), 1e-9);
  const double closing = dt * (workspace.velocity[0].v.z() - workspace.velocity[1].v.z());
  EXPECT_NEAR(closing / 1e-3, 2.0 / 7.0, 1e-12);
}

TEST(PairNormalForce, KeepsLinearMomentumWithThePostCorrectionAndNotWithout) {
  const Scene scene = build_scene(test::stacked_cubes(0.02));
  for (const bool post_correction : {true, false}) {
    Options options = paper();
    options.pairs.post_correction = post_correction;
    test::Found found(scene, options, initial_state(scene));
    pair_normal_forces(scene, options, found.workspace);
    double total = 0.0;
    for (const PairContact& c : found.workspace.pairs) total += options.time_step * c.normal_force;
    const double left = test::momentum(scene, found.workspace.velocity).norm();
    // Round-off of some thirty impulses that cancel.
    if (post_correction) {
      EXPECT_LT(left, 1e-14 * total);
    } else {
      EXPECT_GT(left, 1e-3 * total);
    }
  }
}

TEST(PairNormalForce, TakesAPinnedPartnerAsAnInfiniteMass) {
  SceneDescription description = test::stacked_cubes(0.02);
  for (int v = 0; v < description.bodies[0].mesh.vertices.cols(); ++v) {
    description.bodies[0].pinned.push_back(v);
  }
  const Scene scene = build_scene(description);
  const Options options = paper();
  test::Found found(scene, options, initial_state(scene));
  pair_normal_forces(scene, options, found.workspace);
  for (const PairContact& contact : found.workspace.pairs) {
    if (scene.topology.vertex_body[static_cast<std::size_t>(contact.vertex)] != 1) continue;
    const double mass = scene.mass[static_cast<std::size_t>(contact.vertex)];
    const double full = mass * contact.depth / (options.time_step * options.time_step);
    EXPECT_NEAR(contact.normal_force, 0.5 * full, 1e-12 * full);
  }
}

}  // namespace
}  // namespace stiction
