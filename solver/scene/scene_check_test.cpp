// SPDX-License-Identifier: BSD-3-Clause
#include "solver/scene/scene_check.h"

#include <gtest/gtest.h>

#include <functional>

#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

using test::kInfinity;
using test::kNaN;
using test::refusal;

// A tetrahedron above a plane, in gravity: nothing is wrong with it.
SceneDescription good_scene() {
  SceneDescription scene = test::one_body(test::elastic_body(test::corner_tetrahedron()));
  scene.half_spaces = {test::ground(0.5)};
  scene.gravity = {{0.0, 1.0}, {Vec3::Zero(), Vec3(0, 0, -9.81)}};
  return scene;
}

SceneDescription good_points() {
  return test::one_body(test::point_masses(Eigen::Matrix3Xd::Zero(3, 2), 1.0));
}

TEST(BuildScene, AcceptsWhatIsRight) {
  EXPECT_EQ(refusal([] { build_scene(good_scene()); }), "");
  EXPECT_EQ(refusal([] { build_scene(good_points()); }), "");
}

struct Mistake {
  std::string name;
  std::function<void(SceneDescription&)> make;
  std::string sentence;
  SceneDescription (*scene)() = good_scene;
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.name; }

class BuildSceneRefuses : public testing::TestWithParam<Mistake> {};

TEST_P(BuildSceneRefuses, InOneSentence) {
  SceneDescription scene = GetParam().scene();
  GetParam().make(scene);
  EXPECT_EQ(refusal([&] { build_scene(scene); }), GetParam().sentence);
}

using S = SceneDescription;
Material& material(S& s) { return s.bodies[0].material; }
TetMesh& mesh(S& s) { return s.bodies[0].mesh; }

const Mistake kMistakes[] = {
    {"NoBodies", [](S& s) { s.bodies.clear(); }, "the scene has no bodies"},
    {"NoVertices", [](S& s) { mesh(s) = {}; }, "body 'cube': has no vertices"},
    {"NaNVertex", [](S& s) { mesh(s).vertices(1, 2) = kNaN; },
     "body 'cube': vertex 2 has a coordinate that is not a finite number"},
    {"InfiniteVertex", [](S& s) { mesh(s).vertices(2, 3) = kInfinity; },
     "body 'cube': vertex 3 has a coordinate that is not a finite number"},
    {"IndexTooLarge", [](S& s) { mesh(s).tetrahedra(3, 0) = 4; },
     "body 'cube': tetrahedron 0 refers to vertex 4, but there are only 4 vertices"},
    {"NegativeIndex", [](S& s) { mesh(s).tetrahedra(0, 0) = -1; },
     "body 'cube': tetrahedron 0 refers to vertex -1, but there are only 4 vertices"},
    {"InvertedTetrahedron",
     [](S& s) { std::swap(mesh(s).tetrahedra(1, 0), mesh(s).tetrahedra(2, 0)); },
     "body 'cube': tetrahedron 0 is inverted (volume -0.166666667 m³)"},
    {"FlatTetrahedron", [](S& s) { mesh(s).vertices.col(3) = Vec3(0.25, 0.25, 0.0); },
     "body 'cube': tetrahedron 0 is flat (volume 0 m³, longest edge 1.41421356 m)"},
    {"RepeatedCorner", [](S& s) { mesh(s).tetrahedra(3, 0) = 2; },
     "body 'cube': tetrahedron 0 is flat (volume 0 m³, longest edge 1.41421356 m)"},
    {"AlmostFlatTetrahedron", [](S& s) { mesh(s).vertices.col(3) = Vec3(0.25, 0.25, 1e-13); },
     "body 'cube': tetrahedron 0 is flat (volume 1.66666667e-14 m³, longest edge 1.41421356 m)"},
    {"TetrahedronGivenTwice",
     [](S& s) {
       mesh(s).tetrahedra.conservativeResize(4, 2);
       mesh(s).tetrahedra.col(1) << 1, 2, 0, 3;
     },
     "body 'cube': tetrahedra 0 and 1 have the same corners"},
    {"FrequencyBeyondNumbers",
     [](S& s) {
       material(s).density = 1e-200;
       material(s).youngs_modulus = 1e200;
     },
     "body 'cube': tetrahedron 0 is so thin, stiff or light that no number holds its highest "
     "frequency"},
    {"AlmostFlatInvertedTetrahedron",
     [](S& s) { mesh(s).vertices.col(3) = Vec3(0.25, 0.25, -1e-13); },
     "body 'cube': tetrahedron 0 is flat (volume -1.66666667e-14 m³, longest edge 1.41421356 m)"},
    {"NegativeDensity", [](S& s) { material(s).density = -1000.0; },
     "body 'cube': density must be positive and finite, not -1000 kg/m³"},
    {"ZeroDensity", [](S& s) { material(s).density = 0.0; },
     "body 'cube': density must be positive and finite, not 0 kg/m³"},
    {"NaNDensity", [](S& s) { material(s).density = kNaN; },
     "body 'cube': density must be positive and finite, not nan kg/m³"},
    {"NegativeYoungsModulus", [](S& s) { material(s).youngs_modulus = -1.0; },
     "body 'cube': Young's modulus must be positive and finite, not -1 Pa"},
    {"InfiniteYoungsModulus", [](S& s) { material(s).youngs_modulus = kInfinity; },
     "body 'cube': Young's modulus must be positive and finite, not inf Pa"},
    {"PoissonRatioOfOneHalf", [](S& s) { material(s).poisson_ratio = 0.5; },
     "body 'cube': Poisson's ratio must lie between -1 and 0.5, not 0.5"},
    {"PoissonRatioOfMinusOne", [](S& s) { material(s).poisson_ratio = -1.0; },
     "body 'cube': Poisson's ratio must lie between -1 and 0.5, not -1"},
    {"NaNPoissonRatio", [](S& s) { material(s).poisson_ratio = kNaN; },
     "body 'cube': Poisson's ratio must lie between -1 and 0.5, not nan"},
    {"NegativeDamping", [](S& s) { material(s).damping_time = -1e-3; },
     "body 'cube': damping time must be non-negative and finite, not -0.001 s"},
    {"TooFewVelocities", [](S& s) { s.bodies[0].initial_velocity.setZero(3, 3); },
     "body 'cube': 3 initial velocities for 4 vertices"},
    {"NaNVelocity", [](S& s) { s.bodies[0].initial_velocity.setConstant(3, 4, kNaN); },
     "body 'cube': an initial velocity is not a finite number"},
    {"PinnedVertexTooLarge",
     [](S& s) {
       s.bodies[0].pinned = {0, 4};
     },
     "body 'cube': pinned vertex 4 does not exist, there are 4 vertices"},
    {"PinnedVertexNegative", [](S& s) { s.bodies[0].pinned = {-1}; },
     "body 'cube': pinned vertex -1 does not exist, there are 4 vertices"},
    {"VertexWithoutMass",
     [](S& s) {
       mesh(s).vertices.conservativeResize(3, 5);
       mesh(s).vertices.col(4) = Vec3::Ones();
       s.bodies[0].point_mass = 0.0;
     },
     "body 'cube': vertex 4 belongs to no tetrahedron and needs a positive point mass, not 0 kg"},
    {"NegativePointMass", [](S& s) { s.bodies[0].point_mass = -1.0; },
     "body 'points': vertex 0 belongs to no tetrahedron and needs a positive point mass, not -1 kg",
     good_points},
    {"NaNPointMass", [](S& s) { s.bodies[0].point_mass = kNaN; },
     "body 'points': vertex 0 belongs to no tetrahedron and needs a positive point mass, not nan "
     "kg",
     good_points},
    {"NegativeFriction", [](S& s) { s.half_spaces[0].friction = -0.5; },
     "obstacle 'ground': the friction coefficient must be non-negative and finite, not -0.5"},
    {"NaNFriction", [](S& s) { s.half_spaces[0].friction = kNaN; },
     "obstacle 'ground': the friction coefficient must be non-negative and finite, not nan"},
    {"LongNormal", [](S& s) { s.half_spaces[0].normal = Vec3(0, 0, 2); },
     "obstacle 'ground': its normal must have length 1, not 2"},
    {"ZeroNormal", [](S& s) { s.half_spaces[0].normal = Vec3::Zero(); },
     "obstacle 'ground': its normal must have length 1, not 0"},
    {"NaNNormal", [](S& s) { s.half_spaces[0].normal = Vec3(0, 0, kNaN); },
     "obstacle 'ground': its normal must have length 1, not nan"},
    {"InfiniteObstaclePoint", [](S& s) { s.half_spaces[0].point.x() = kInfinity; },
     "obstacle 'ground': its point is not a finite number"},
    {"KeyframesOutOfOrder",
     [](S& s) {
       s.gravity.time = {1.0, 0.5};
     },
     "gravity: keyframe 1 at 0.5 s does not follow 1 s"},
    {"RepeatedKeyframe",
     [](S& s) {
       s.gravity.time = {1.0, 1.0};
     },
     "gravity: keyframe 1 at 1 s does not follow 1 s"},
    {"MissingAcceleration", [](S& s) { s.gravity.acceleration.pop_back(); },
     "gravity: 2 times for 1 accelerations"},
    {"NaNAcceleration", [](S& s) { s.gravity.acceleration[1].y() = kNaN; },
     "gravity: keyframe 1 is not a finite number"},
    {"NaNKeyframe", [](S& s) { s.gravity.time[0] = kNaN; },
     "gravity: keyframe 0 is not a finite number"},
    {"NegativeFrictionBetweenBodies", [](S& s) { s.friction = -1.0; },
     "the friction coefficient between bodies must be non-negative and finite, not -1"},
    {"NaNFrictionBetweenBodies", [](S& s) { s.friction = kNaN; },
     "the friction coefficient between bodies must be non-negative and finite, not nan"},
    {"PairThatIsNotThere",
     [](S& s) {
       s.pair_friction = {{.body = 0, .other = 1, .against_body = false, .friction = 0.5}};
     },
     "a pair with a friction coefficient of its own names what is not there"},
    {"NegativePairFriction", [](S& s) { s.pair_friction = {{.friction = -0.5}}; },
     "the friction coefficient of a pair must be non-negative and finite, not -0.5"},
    {"PairGivenTwice",
     [](S& s) {
       s.pair_friction = {{.friction = 0.5}, {.friction = 0.25}};
     },
     "two friction coefficients are given for one pair"},
    {"MotionOutOfOrder",
     [](S& s) {
       s.bodies[0].motion = {{1.0, 0.5}, {Vec3::Zero(), Vec3::Zero()}};
     },
     "body 'cube', its motion: keyframe 1 at 0.5 s does not follow 1 s"},
    {"NaNObstacleMotion",
     [](S& s) {
       s.half_spaces[0].motion = {{0.0}, {Vec3(0, 0, kNaN)}};
     },
     "obstacle 'ground', its motion: keyframe 0 is not a finite number"},
    {"StartsInside", [](S& s) { s.half_spaces[0].point.z() = 0.25; },
     "body 'cube': starts 0.25 m inside obstacle 'ground'"},
};

INSTANTIATE_TEST_SUITE_P(Scenes, BuildSceneRefuses, testing::ValuesIn(kMistakes),
                         [](const auto& one) { return one.param.name; });

TEST(CheckStart, NamesTheSecondBodyAndObstacle) {
  SceneDescription scene = good_scene();
  scene.bodies.push_back(scene.bodies[0]);
  scene.bodies[1].name = "lower";
  scene.bodies[1].mesh.vertices.row(2).array() -= 0.5;
  scene.half_spaces = {{"deep", Vec3(0, 0, -1), Vec3::UnitZ(), 0.0}, test::ground(0.0)};
  EXPECT_EQ(refusal([&] { build_scene(scene); }),
            "body 'lower': starts 0.5 m inside obstacle 'ground'");
}

TEST(CheckStart, AllowsRoundOffOfAPlacedMeshAndNoMore) {
  SceneDescription scene = good_scene();
  scene.half_spaces[0].point.z() = 0.9e-13;  // allowed: 1e-13 of a metre-sized scene
  EXPECT_EQ(refusal([&] { build_scene(scene); }), "");
  scene.half_spaces[0].point.z() = 1.1e-13;
  EXPECT_NE(refusal([&] { build_scene(scene); }), "");
}

TEST(CheckStart, AllowsPinnedVerticesInside) {
  SceneDescription scene = good_scene();
  scene.half_spaces[0].point.z() = 0.25;
  scene.bodies[0].pinned = {0, 1, 2};  // the three at z = 0
  EXPECT_EQ(refusal([&] { build_scene(scene); }), "");
}

}  // namespace
}  // namespace stiction
