// SPDX-License-Identifier: BSD-3-Clause
#include "solver/depth/staying.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cfenv>
#include <numeric>
#include <vector>

#include "solver/depth/face_choice.h"
#include "solver/depth/remember_pairs.h"
#include "solver/depth/same_face.h"
#include "solver/detection/pair_candidates.h"
#include "solver/testing/test_pairs.h"

namespace stiction {
namespace {

Options quiet() { return {}; }

// Of the paper: the nearest face, whichever it was before.
Options nearest() {
  Options options;
  options.pairs.face = PairFace::kNearest;
  options.pairs.tie_margin = 0.0;
  options.pairs.hysteresis = 0.0;
  options.pairs.border_margin = 0.0;
  return options;
}

struct Motion {
  Vec3 shift;           // of the upper cube from where it stands flush on the lower one, m
  Vec3 each_step;       // m
  double tremble;       // m
  double depth = 1e-3;  // in which it begins, m
};

// A cube stands on another, goes its way and trembles. Each step is measured by what is known of
// those before, and by asking everything anew. Returns how many contacts were known to stay where
// their lists alone don't tell.
std::size_t expect_what_asking_finds(const Options& base, const Motion& motion) {
  SceneDescription description = test::stacked_cubes(motion.depth, motion.shift);
  description.gravity = {{0.0}, {Vec3(0, 0, -9.81)}};
  const Scene scene = build_scene(description);
  Options options = base;
  options.time_step = 0.1 * scene.stable_time_step;
  State state = initial_state(scene);
  Workspace kept;
  kept.velocity = state.velocity;
  std::size_t known = 0;
  std::feclearexcept(FE_ALL_EXCEPT);
  for (unsigned k = 0; k < 300; ++k) {
    state.position = test::on_its_way(scene, k, motion.each_step, motion.tremble).position;
    detect_pairs(scene, options, state, kept);
    for (const PairContact& contact : kept.pairs) {
      const PairSearch::Group* const group = test::group_of(kept.search, contact.key());
      if (group == nullptr) continue;
      const PairSite& site = kept.pairs.site_of(contact);
      known += stays_on_face(scene.topology, options.pairs, kept.search, site, *group);
    }
    const PairContacts asked = test::measured_by_depths(scene, options, state, kept, true);
    depths(scene, options, state, kept);
    const bool same =
        std::equal(asked.begin(), asked.end(), kept.pairs.begin(), kept.pairs.end(),
                   [&](const PairContact& one, const PairContact& other) {
                     return test::numbers_of(asked, one) == test::numbers_of(kept.pairs, other);
                   });
    EXPECT_TRUE(same) << "step " << k;
    if (!same) break;
    remember_pairs(kept.pairs, scene.topology, state.pair_geometry);
  }
  EXPECT_EQ(std::fetestexcept(FE_DIVBYZERO | FE_INVALID), 0);
  return known;
}

TEST(Staying, IsKnownOfCubesThatStandAndTremble) {
  for (const Options& options : {quiet(), nearest()}) {
    std::size_t known = 0;
    for (const Vec3& shift : {Vec3(0, 0, 0), Vec3(0.21, 0.13, 0), Vec3(1e-4, 0, 0)}) {
      for (const double tremble : {0.0, 1e-12, 1e-9}) {
        SCOPED_TRACE(testing::Message() << shift.transpose() << ", " << tremble);
        known += expect_what_asking_finds(options, {shift, Vec3::Zero(), tremble});
      }
    }
    EXPECT_GT(known, 10000u);
  }
}

TEST(Staying, EndsInTimeWhereACubeGoesOverEdgesAndCorners) {
  for (const Options& options : {quiet(), nearest()}) {
    std::size_t known = 0;
    for (const Vec3& way : {Vec3(1e-6, 0, 0), Vec3(2e-5, 1e-5, 0), Vec3(-3e-4, 1e-4, 1e-6),
                            Vec3(0, 0, 1e-5), Vec3(4e-3, -3e-3, 0), Vec3(1e-4, 0, -1e-4)}) {
      for (const double tremble : {0.0, 1e-7, 1e-5}) {
        SCOPED_TRACE(testing::Message() << way.transpose() << ", " << tremble);
        const Vec3 shift(-0.004, 0.003, 0);
        known += expect_what_asking_finds(options, {shift, way, tremble});
        known += expect_what_asking_finds(options, {shift, 1e-2 * way, 1e-2 * tremble, 1e-6});
      }
    }
    EXPECT_GT(known, 10000u);
  }
}

// What is known of faces that vertices can rest on is not known of the nearest.
TEST(Staying, IsForgottenWithOtherOptions) {
  const Scene scene = build_scene(test::stacked_cubes(1e-3, Vec3(-8e-4, 0.05, 0)));
  Options options = nearest();
  options.time_step = 0.1 * scene.stable_time_step;
  State state = initial_state(scene);
  Workspace kept;
  std::vector<Vec3> normals;
  for (const PairFace face : {PairFace::kOpposed, PairFace::kNearest, PairFace::kOpposed}) {
    options.pairs.face = face;
    for (int k = 0; k < 12; ++k) {
      Workspace fresh;
      for (Workspace* workspace : {&fresh, &kept}) {
        workspace->velocity = state.velocity;
        detect_pairs(scene, options, state, *workspace);
        depths(scene, options, state, *workspace);
      }
      ASSERT_EQ(fresh.pairs.size(), kept.pairs.size());
      for (std::size_t c = 0; c < fresh.pairs.size(); ++c) {
        EXPECT_EQ(test::numbers_of(fresh.pairs, fresh.pairs[c]),
                  test::numbers_of(kept.pairs, kept.pairs[c]))
            << k;
        normals.push_back(fresh.pairs[c].normal);
      }
      remember_pairs(kept.pairs, scene.topology, state.pair_geometry);
    }
  }
  const auto sideways = [](const Vec3& normal) { return std::abs(normal.x()) > 0.5; };
  EXPECT_GT(std::count_if(normals.begin(), normals.end(), sideways), 12) << "the nearest is a side";
}

// A cube that stands on a corner or an edge of its, somewhere near the rim of a rough one.
Scene tumbled(unsigned seed) {
  SceneDescription description = test::stacked_cubes(0.0, Vec3::Zero());
  const Eigen::Matrix3Xd random = test::noise(3, 1.0, seed);
  Eigen::Matrix3Xd& upper = description.bodies[1].mesh.vertices;
  const Eigen::Vector3d centre = upper.rowwise().mean();
  const Eigen::Matrix3d turned =
      Eigen::AngleAxisd(3.14 * random(0, 0), random.col(1).normalized()).toRotationMatrix();
  upper = (turned * (upper.colwise() - centre)).eval();
  Eigen::Index lowest = 0;
  upper.row(2).minCoeff(&lowest);
  const Eigen::Vector3d foot(0.02 * random(0, 2), 0.5 + 0.5 * random(1, 2), 0.99);
  upper.colwise() += (foot - upper.col(lowest)).eval();
  for (BodyDescription& body : description.bodies) {
    body.mesh.vertices += test::noise(body.mesh.vertices.cols(), 0.02, 1000 + seed);
  }
  return build_scene(description);
}

// A cube flush on another, its outer vertices hardly inside the other's sides, its inner ones over edges or
// corners; both are uneven by a share of the depth.
Scene flush(unsigned seed) {
  const Eigen::Vector3d random = test::noise(1, 1.0, seed).col(0);
  const double depth = std::pow(10.0, -1.5 - seed % 4);
  SceneDescription description = test::stacked_cubes(depth, Vec3::Zero());
  Eigen::Matrix3Xd& upper = description.bodies[1].mesh.vertices;
  const double smaller = 1.0 - 2.0 * depth * std::pow(10.0, -1.0 - seed % 3);
  upper.topRows<2>() = ((upper.topRows<2>().array() - 0.5) * smaller + 0.5).matrix().eval();
  if (seed % 2 == 0) upper.row(0).array() += 0.1 * depth * random.x();
  for (BodyDescription& body : description.bodies) {
    body.mesh.vertices +=
        test::noise(body.mesh.vertices.cols(), 0.02 * depth * std::abs(random.y()), 1000 + seed);
  }
  return build_scene(description);
}

// Moves what a bound says may move, in many directions, and asks again.
TEST(Staying, IsABoundOnWhatMayMove) {
  std::size_t moved = 0, told[2] = {};
  std::vector<unsigned> seeds(500);
  std::iota(seeds.begin(), seeds.end(), 0U);
  // Of 20000 those in which the vertex can only just rest on its own face.
  seeds.insert(seeds.end(), {1202, 10688, 10961, 11734});
  std::vector<Scene> scenes;
  for (const unsigned seed : seeds) scenes.push_back(tumbled(seed));
  for (unsigned seed = 0; seed < 60; ++seed) scenes.push_back(flush(seed));
  for (const Scene& scene : scenes) {
    const auto seed = &scene - scenes.data();
    if (static_cast<std::size_t>(seed) % test::kOneIn != 0) continue;
    for (Options options : {quiet(), nearest()}) {
      options.time_step = 0.1 * scene.stable_time_step;
      State state = initial_state(scene);
      Workspace workspace;
      workspace.velocity = state.velocity;
      for (int k = 0; k < 3; ++k) {
        detect_pairs(scene, options, state, workspace);
        depths(scene, options, state, workspace);
        remember_pairs(workspace.pairs, scene.topology, state.pair_geometry);
      }
      PairContacts found = workspace.pairs;
      detect_pairs(scene, options, state, workspace);
      PairSearch& search = workspace.search;
      for (PairContact& contact : workspace.pairs) {
        PairSite& site = workspace.pairs.site_of(contact);
        const PairSearch::Group* const group = test::group_of(search, contact.key());
        const auto was = std::find_if(found.begin(), found.end(), [&](const PairContact& one) {
          return one.key() == contact.key();
        });
        if (was == found.end() || group == nullptr || group->near_element != site.element) continue;
        if (site.triangle < 0) site.triangle = found.site_of(*was).triangle;
        const Staying staying = stays_within(scene.topology, options.pairs, search, *group, site);
        const Real within = std::min(staying.within, search.skin);
        if (!(within > 0.0)) continue;
        for (unsigned k = 0; k < 60; ++k) {
          PairSearch other = search;
          const Eigen::Matrix3Xd way =
              test::noise(scene.vertex_count(), 1.0, 7 + k).colwise().normalized();
          const Real share = Real(0.5) * (k % 3);  // of the vertex
          const auto& lower = scene.bodies[static_cast<std::size_t>(contact.other)];
          const int own = contact.vertex;
          for (int v = 0; v < scene.vertex_count(); ++v) {
            const bool of_lower =
                v >= lower.first_vertex && v < lower.first_vertex + lower.vertex_count;
            const Real by = Real(0.999) * within * (of_lower ? 1 - share : share);
            other.predicted[static_cast<std::size_t>(v)] += by * way.col(v).cast<Real>();
          }
          other.moved[static_cast<std::size_t>(contact.other)] += within;
          const Vec3& point = other.predicted[static_cast<std::size_t>(own)];
          const Choice choice = choose_face(scene.topology, state, other, nullptr, point, site,
                                            options.pairs.tie_margin,
                                            options.pairs.face == PairFace::kOpposed ? own : -1);
          const Projection last = project_on(scene.topology, other.predicted, point, site.triangle);
          if (!is_over(scene.topology, other.predicted, point, last)) continue;
          ++moved;
          EXPECT_EQ(choice.projection.triangle, site.triangle)
              << "scene " << seed << ", vertex " << own << ", within " << within;
          if (staying.passes_over >= 0) {
            ++told[staying.passes_over];
            EXPECT_EQ(choice.passed_over, staying.passes_over == 1) << "scene " << seed;
          }
        }
      }
    }
  }
  EXPECT_GT(moved, 10000 / test::kOneIn);
  EXPECT_GT(told[0], 10000 / test::kOneIn);
  EXPECT_GT(told[1], 1000 / test::kOneIn);
}

}  // namespace
}  // namespace stiction
