// SPDX-License-Identifier: BSD-3-Clause
#include "solver/depth/same_face.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "solver/depth/remember_pairs.h"
#include "solver/lanes/lane_width.h"
#include "solver/testing/test_pairs.h"

namespace stiction {
namespace {

// A jittered block that slides over another, some steps on; their contacts as detection leaves them.
struct Sliding {
  Scene scene;
  Options options;
  State state;
  Workspace workspace;

  explicit Sliding(PairWeights weights, bool friction_reaction) {
    SceneDescription description;
    description.bodies = {test::elastic_body(test::grid_mesh({6, 6, 2}, 0.1)),
                          test::elastic_body(test::grid_mesh({9, 9, 1}, 0.05))};
    for (BodyDescription& body : description.bodies) {
      body.mesh.vertices += test::noise(body.mesh.vertices.cols(), 2e-3, 3);
    }
    BodyDescription& upper = description.bodies[1];
    upper.mesh.vertices.colwise() += Vec3(0.013, 0.017, 0.195);
    scene = build_scene(description);
    options.time_step = 0.1 * scene.stable_time_step;
    options.pairs.weights = weights;
    options.pairs.friction_reaction = friction_reaction;
    options.pairs.tie_margin = 1e-3;  // for which triangles are kept
    state = initial_state(scene);
    workspace.velocity = state.velocity;
    for (int k = 0; k < 4; ++k) {
      if (k > 0) {
        depths(scene, options, state, workspace);
        remember_pairs(workspace.pairs, scene.topology, state.pair_geometry);
      }
      for (std::size_t v = 0; v < state.position.size(); ++v) {
        if (scene.topology.vertex_body[v] == 1) state.position[v].x += Vec3(2e-4, 1e-4, -1e-5);
      }
      detect_pairs(scene, options, state, workspace);
    }
  }

  PairContacts measured(bool one_at_a_time) const {
    return test::measured_by_depths(scene, options, state, workspace, one_at_a_time);
  }
};

class SameFace : public testing::TestWithParam<std::tuple<PairWeights, bool>> {};

TEST_P(SameFace, InABatchHasTheBitsOfOneAtATime) {
  const auto [weights, reaction] = GetParam();
  const Sliding sliding(weights, reaction);
  const PairContacts alone = sliding.measured(true), together = sliding.measured(false);
  ASSERT_GT(alone.size(), 50u);
  ASSERT_EQ(alone.size(), together.size());
  for (std::size_t c = 0; c < alone.size(); ++c) {
    EXPECT_EQ(test::numbers_of(alone, alone[c]), test::numbers_of(together, together[c])) << c;
  }
}

TEST_P(SameFace, HasTheSameBitsAtEachWidth) {
  const auto [weights, reaction] = GetParam();
  Sliding sliding(weights, reaction);
  const PairContacts alone = sliding.measured(true);
  const OpenLimits limits(sliding.scene, sliding.options, sliding.state);
  for (const int width : lane_widths()) {
    PairContacts pairs = sliding.workspace.pairs;
    std::size_t measured = 0, asked = 0;
    FaceBatch batch;
    const auto measure = [&] {
      const unsigned left =
          measure_on_same_face(sliding.scene, sliding.options.pairs, sliding.state,
                               sliding.workspace, limits, width, batch);
      for (int k = 0; k < batch.count; ++k) {
        const auto was = std::find_if(alone.begin(), alone.end(), [&](const PairContact& one) {
          return one.key() == batch.contact[k]->key();
        });
        const bool done = (left >> k & 1U) == 0;
        measured += done;
        if (!done) continue;
        EXPECT_EQ(test::numbers_of(pairs, *batch.contact[k]), test::numbers_of(alone, *was))
            << "width " << width;
      }
      asked += static_cast<std::size_t>(batch.count);
      batch.clear();
    };
    // Batches of all sizes, the last one of a few too.
    std::size_t most = 1;
    for (PairContact& contact : pairs) {
      PairSearch::Group* const group = test::group_of(sliding.workspace.search, contact.key());
      PairSite& site = pairs.site_of(contact);
      if (group == nullptr || !may_stay_on_face(site, *group)) continue;
      batch.add(sliding.scene.topology, contact, site, *group, false);
      if (static_cast<std::size_t>(batch.count) < most) continue;
      measure();
      most = most % static_cast<std::size_t>(lanes_of(width)) + 1;
    }
    if (batch.count > 0) measure();
    EXPECT_GT(asked, pairs.size() / 2);
    EXPECT_GT(measured, asked / 2);
  }
}

TEST(FaceBatch, LeavesContactsThatHaveComeToAnotherFaceOrAreNoNumbers) {
  Sliding sliding(PairWeights::kTetrahedron, true);
  PairContacts pairs = sliding.workspace.pairs;
  PairSearch& search = sliding.workspace.search;
  const OpenLimits limits(sliding.scene, sliding.options, sliding.state);
  std::size_t tried = 0;
  for (PairContact& contact : pairs) {
    PairSearch::Group* const group = test::group_of(search, contact.key());
    PairSite& site = pairs.site_of(contact);
    if (group == nullptr || !may_stay_on_face(site, *group)) continue;
    ++tried;
    const auto before = test::numbers_of(pairs, contact);
    Vec3& point = search.predicted[static_cast<std::size_t>(contact.vertex)];
    const Vec3 was = point;
    FaceBatch batch;
    batch.add(sliding.scene.topology, contact, site, *group, false);
    for (const Vec3& elsewhere : {Vec3(was + Vec3(0.2, 0.0, 0.0)), Vec3(was - Vec3(0, 0, 0.09)),
                                  Vec3(test::kNaN, 0.0, 0.0)}) {
      point = elsewhere;
      for (const int width : lane_widths()) {
        EXPECT_EQ(measure_on_same_face(sliding.scene, sliding.options.pairs, sliding.state,
                                       sliding.workspace, limits, width, batch),
                  1u);
        EXPECT_EQ(test::numbers_of(pairs, contact), before);
      }
    }
    point = was;
  }
  EXPECT_GT(tried, 20u);
}

// Most have no other triangle near enough to compare, and are not to be asked about it in each step.
TEST(FaceBatch, OfBodiesThatStandStillKnowsItsFaces) {
  Sliding still(PairWeights::kTetrahedron, true);
  PairContacts& pairs = still.workspace.pairs;
  for (int k = 0; k <= kStepsToAsk; ++k) {
    depths(still.scene, still.options, still.state, still.workspace);
    remember_pairs(pairs, still.scene.topology, still.state.pair_geometry);
    detect_pairs(still.scene, still.options, still.state, still.workspace);
  }
  std::size_t known = 0;
  for (const PairContact& contact : pairs) {
    const PairSearch::Group* const group = test::group_of(still.workspace.search, contact.key());
    known +=
        group != nullptr && stays_on_face(still.scene.topology, still.options.pairs,
                                          still.workspace.search, pairs.site_of(contact), *group);
  }
  ASSERT_GT(pairs.size(), 50u);
  EXPECT_GT(known, pairs.size() * 9 / 10);
}

// Two cubes, one flush on the other, of which every vertex is moved a little in each of a few steps: over corners
// and edges others are as near or nearer than the own triangle, side walls among them, on which none can rest.
TEST(FaceBatch, OfFlushFacesHasTheBitsOfOneAtATime) {
  std::size_t contacts = 0, compared = 0, left = 0;
  for (int seed = 0; seed < 40; ++seed) {
    const double size = std::pow(10.0, -4 - seed % 5);
    SceneDescription description;
    description.bodies = {test::elastic_body(test::grid_mesh({2, 2, 2}, 0.05)),
                          test::elastic_body(test::grid_mesh({2, 2, 2}, 0.05))};
    description.bodies[1].mesh.vertices.colwise() += Vec3(0, 0, 0.1 - 1e-5);
    const Scene scene = build_scene(description);
    Options options;
    options.time_step = 0.1 * scene.stable_time_step;
    ASSERT_EQ(options.pairs.face, PairFace::kOpposed);
    ASSERT_GT(options.pairs.tie_margin, 0.0);
    State state = initial_state(scene);
    Workspace workspace;
    workspace.velocity = state.velocity;
    for (int k = 0; k < 4; ++k) {
      const auto moved =
          test::noise(static_cast<Eigen::Index>(state.position.size()), size, 4 * seed + k);
      for (std::size_t v = 0; v < state.position.size(); ++v) {
        state.position[v].x += moved.col(static_cast<Eigen::Index>(v));
      }
      detect_pairs(scene, options, state, workspace);
      const auto measured = [&](bool one_at_a_time) {
        return test::measured_by_depths(scene, options, state, workspace, one_at_a_time);
      };
      const PairContacts alone = measured(true), together = measured(false);
      ASSERT_EQ(alone.size(), together.size());
      contacts += alone.size();
      for (std::size_t c = 0; c < alone.size(); ++c) {
        EXPECT_EQ(test::numbers_of(alone, alone[c]), test::numbers_of(together, together[c]))
            << "seed " << seed << ", step " << k << ", contact " << c;
      }
      const OpenLimits limits(scene, options, state);
      for (PairContact& contact : workspace.pairs) {
        PairSite& site = workspace.pairs.site_of(contact);
        PairSearch::Group* const group = test::group_of(workspace.search, contact.key());
        if (group == nullptr || !may_stay_on_face(site, *group)) continue;
        PairContact copy = contact;
        PairSite copied = site;
        FaceBatch batch;
        batch.add(scene.topology, copy, copied, *group, false);
        left += measure_on_same_face(scene, options.pairs, state, workspace, limits, lane_width(),
                                     batch) != 0;
        compared += batch.compared != 0;
      }
      depths(scene, options, state, workspace);
      remember_pairs(workspace.pairs, scene.topology, state.pair_geometry);
    }
  }
  EXPECT_GT(contacts, 1000u);
  EXPECT_GT(compared, contacts / 2);
  EXPECT_LT(left, compared / 2);
}

// As contacts may be that a workspace has of a later time than the state.
TEST(FaceBatch, SaysWhereAContactHadOtherPartners) {
  const Sliding sliding(PairWeights::kTriangle, true);
  const auto depths_again = [&](Workspace workspace) {
    depths(sliding.scene, sliding.options, sliding.state, workspace);
    return workspace;
  };
  const Workspace measured = depths_again(sliding.workspace);
  const PairContacts& pairs = measured.pairs;
  EXPECT_EQ(depths_again(measured).pairs.same_order, pairs.same_order);
  for (std::size_t c = 0; c < pairs.size(); ++c) {
    Workspace later = measured;
    std::swap(later.pairs[c].partner[0], later.pairs[c].partner[1]);
    const PairContacts now = depths_again(later).pairs;
    EXPECT_EQ(std::to_array(now[c].partner), std::to_array(pairs[c].partner)) << c;
    EXPECT_NE(now.same_order, pairs.same_order) << c;
  }
}

INSTANTIATE_TEST_SUITE_P(Weights, SameFace,
                         testing::Combine(testing::Values(PairWeights::kTriangle,
                                                          PairWeights::kTetrahedron),
                                          testing::Bool()),
                         [](const auto& one) {
                           return std::string(std::get<0>(one.param) == PairWeights::kTriangle
                                                  ? "Triangle"
                                                  : "Tetrahedron") +
                                  (std::get<1>(one.param) ? "BothWays" : "OneWay");
                         });

}  // namespace
}  // namespace stiction
