// SPDX-License-Identifier: BSD-3-Clause
// Threads inside a step leave the bits as they are.
#include <gtest/gtest.h>

#include <algorithm>

#include "solver/parallel/team.h"
#include "solver/step.h"
#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

constexpr int kSteps = 12;
constexpr double kCell = 0.01;  // m

// A plate that slides over a larger one on the ground, with more contacts of both kinds than threads
// need, some of which come and go.
Scene sliding_plates() {
  const Material material{1000.0, 1e5, 0.3, 1e-4};
  SceneDescription description;
  BodyDescription lower = test::elastic_body(test::grid_mesh({68, 68, 1}, kCell), material);
  lower.name = "lower";
  BodyDescription upper = test::elastic_body(test::grid_mesh({48, 48, 1}, kCell), material);
  upper.name = "upper";
  lower.initial_velocity = Vec3(0.0, 0.0, -0.05).replicate(1, lower.mesh.vertices.cols());
  upper.mesh.vertices.colwise() += Vec3(0.103, 0.107, kCell - 1e-6);
  upper.initial_velocity = Vec3(2.0, 1.0, -0.05).replicate(1, upper.mesh.vertices.cols()) +
                           test::noise(upper.mesh.vertices.cols(), 0.01, 7);
  description.bodies = {lower, upper};
  description.half_spaces = {test::ground(0.4)};
  description.gravity = {{0.0}, {Vec3(10.0, 0.0, -200.0)}};
  description.friction = 0.3;
  return build_scene(description);
}

// Bars across bars, which meet by their edges, some at once and others later.
Scene crossed_bars() {
  constexpr int kBars = 24;
  const Material material{1000.0, 1e5, 0.3, 1e-4};
  SceneDescription description;
  for (const bool above : {false, true}) {
    for (int k = 0; k < kBars; ++k) {
      const Eigen::Vector3i cells =
          above ? Eigen::Vector3i(1, 2 * kBars, 1) : Eigen::Vector3i(2 * kBars, 1, 1);
      BodyDescription bar = test::elastic_body(test::grid_mesh(cells, kCell), material);
      bar.name = (above ? "above " : "below ") + std::to_string(k);
      const double aside = (2.0 * k + 0.37) * kCell;
      const double gap = 1e-5 * (k % 7 - 1);
      bar.mesh.vertices.colwise() += above ? Vec3(aside, 0.0, kCell + gap) : Vec3(0.0, aside, 0.0);
      bar.initial_velocity =
          Vec3(0.0, 0.0, above ? -0.2 : 0.0).replicate(1, bar.mesh.vertices.cols()) +
          test::noise(bar.mesh.vertices.cols(), 0.01, static_cast<unsigned>(k));
      description.bodies.push_back(std::move(bar));
    }
  }
  description.friction = 0.3;
  return build_scene(description);
}

struct Ran {
  std::uint64_t hash = 0;
  std::size_t pairs = 0, obstacles = 0, edge_candidates = 0;
  std::size_t edges = 0;  // of all steps
};

Ran run(const Scene& scene, const Options& options, const Team* team) {
  State state = initial_state(scene);
  Workspace workspace;
  workspace.team = team;
  std::size_t edges = 0;
  for (int k = 0; k < kSteps; ++k) {
    step(scene, options, state, workspace);
    edges += workspace.edges.size();
  }
  return {hash_of(state), workspace.pairs.size(), workspace.contacts.size(),
          workspace.search.edge_candidate.size(), edges};
}

Options quiet() { return {.time_step = 5e-5}; }

// The paper's contacts: pair by pair, one sweep.
Options paper() {
  Options options{.time_step = 5e-5, .rule = "fixed-point"};
  options.pairs.gain = NormalGain::kPaper;
  options.pairs.weights = PairWeights::kTriangle;
  options.pairs.normals_first = false;
  options.pairs.key = PairKey::kTriangle;
  return options;
}

TEST(StepThreads, HaveTheBitsOfOneAtAnyNumber) {
  if (most_threads() == 1) GTEST_SKIP() << "built without oneTBB";
  const Scene scene = sliding_plates();
  for (const Options& options : {quiet(), paper()}) {
    const Ran alone = run(scene, options, nullptr);
    ASSERT_GE(alone.pairs, ContactOrder::kMany);
    ASSERT_GE(alone.obstacles, ContactOrder::kMany);
    for (const int threads : {1, 2, 3, 8}) {
      const Team team(threads);
      EXPECT_EQ(run(scene, options, &team).hash, alone.hash)
          << options.rule << " with " << threads << " threads";
    }
  }
}

TEST(StepThreads, HaveTheBitsOfOneWhereEachStepIsLeftToWhoTakesLess) {
  const Scene scene = sliding_plates();
  const Team team(std::min(2, most_threads()));
  TeamChoice choice(team);
  State alone = initial_state(scene), chosen = alone;
  Workspace of_alone, of_chosen;
  of_chosen.team_choice = &choice;
  int by_team = 0;
  for (int k = 0; k < TeamChoice::kFirst + TeamChoice::kTrial; ++k) {
    step(scene, quiet(), alone, of_alone);
    step(scene, quiet(), chosen, of_chosen);
    by_team += of_chosen.team != nullptr;
  }
  EXPECT_EQ(hash_of(chosen), hash_of(alone));
  EXPECT_EQ(by_team, TeamChoice::kFirst + TeamChoice::kTrial / 2);
}

TEST(StepThreads, HaveTheBitsOfOneWhereEdgesCross) {
  if (most_threads() == 1) GTEST_SKIP() << "built without oneTBB";
  const Scene scene = crossed_bars();
  const Ran alone = run(scene, quiet(), nullptr);
  ASSERT_GE(alone.edge_candidates, 2048u) << "two threads take half each";
  ASSERT_GE(alone.edges, 2000u);
  for (const int threads : {2, 3, 8}) {
    const Team team(threads);
    const Ran together = run(scene, quiet(), &team);
    EXPECT_EQ(together.hash, alone.hash) << threads << " threads";
    EXPECT_EQ(together.edges, alone.edges) << threads << " threads";
  }
}

TEST(StepThreads, ASnapshotGoesOnAsItDid) {
  const Scene scene = sliding_plates();
  State state = initial_state(scene);
  Workspace workspace;
  for (int k = 0; k < kSteps / 2; ++k) step(scene, quiet(), state, workspace);
  const State kept = state;
  for (int k = 0; k < kSteps / 2; ++k) step(scene, quiet(), state, workspace);
  const std::uint64_t hash = hash_of(state);
  state = kept;
  Workspace fresh;
  for (int k = 0; k < kSteps / 2; ++k) step(scene, quiet(), state, fresh);
  EXPECT_EQ(hash_of(state), hash);
}

}  // namespace
}  // namespace stiction
