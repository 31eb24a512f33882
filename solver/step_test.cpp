// SPDX-License-Identifier: BSD-3-Clause
#include "solver/step.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>

#include "solver/observables.h"
#include "solver/testing/test_pairs.h"
#include "solver/testing/test_scenes.h"

namespace {

std::atomic<long> allocations{0};

}  // namespace

// Every allocation of this test program is counted, below operator new: Eigen's dynamic matrices
// call malloc themselves. The sanitizers replace malloc and offer a hook; elsewhere glibc lets a
// program put its own in front.
#ifdef STICTION_SANITIZES_MEMORY

// GCC of Debian does not install sanitizer/allocator_interface.h.
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*on_malloc)(const volatile void*,
                                                                           std::size_t),
                                                         void (*on_free)(const volatile void*));

namespace {

[[maybe_unused]] const int hooked = __sanitizer_install_malloc_and_free_hooks(
    [](const volatile void*, std::size_t) { ++allocations; }, [](const volatile void*) {});

}  // namespace

#else

extern "C" {

void* __libc_malloc(std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) noexcept {
  ++allocations;
  return __libc_malloc(size);
}
void* realloc(void* memory, std::size_t size) noexcept {
  ++allocations;
  return __libc_realloc(memory, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  ++allocations;
  return __libc_memalign(alignment, size);
}

}  // extern "C"

#endif

namespace stiction {
namespace {

// A small elastic cube that slides over the ground and bumps into a wall.
Scene sliding_cube() {
  BodyDescription body = test::elastic_body(test::cube_mesh(2, 0.1), {1000.0, 1e5, 0.3, 1e-4});
  body.initial_velocity = Vec3(-0.5, 0.2, 0.0).replicate(1, 27);
  SceneDescription description = test::one_body(body);
  description.half_spaces = {test::ground(0.5), {"wall", Vec3(-0.01, 0, 0), Vec3::UnitX(), 0.3}};
  description.gravity = {{0.0}, {Vec3(0, 0, -9.81)}};
  return build_scene(description);
}

void advance(const Scene& scene, const Options& options, State& state, Workspace& workspace,
             int steps) {
  check_options(options, scene);
  for (int k = 0; k < steps; ++k) step(scene, options, state, workspace);
}

class StepWithRule : public testing::TestWithParam<std::string> {
 protected:
  const Options options{.time_step = 2e-4, .rule = GetParam()};
};

TEST(AllocationCounter, SeesVectorsAndEigenMatrices) {
  allocations = 0;
  const std::vector<Vec3> plain(3);
  EXPECT_EQ(allocations.load(), 1);
  const std::vector<Velocity> aligned(3);
  EXPECT_EQ(allocations.load(), 2);
  const Eigen::Matrix3Xd matrix = Eigen::Matrix3Xd::Zero(3, 3);
  EXPECT_EQ(allocations.load(), 3);
}

TEST_P(StepWithRule, AllocatesNothingOnceWarm) {
  const Scene scene = sliding_cube();
  const State start = initial_state(scene);
  State state = start;
  Workspace workspace;
  advance(scene, options, state, workspace, 400);
  // Once around, every array has seen its largest size; the capacity of both memories too, since
  // they are exchanged every step and 400 is even.
  state = start;
  advance(scene, options, state, workspace, 1);
  allocations = 0;
  for (int k = 0; k < 399; ++k) step(scene, options, state, workspace);
  EXPECT_EQ(allocations.load(), 0);
  EXPECT_GT(workspace.contact_updates, 2u * 400u) << "with contacts to allocate for";
}

TEST_P(StepWithRule, GivesTheSameHashOnEveryRun) {
  const Scene scene = sliding_cube();
  std::vector<std::uint64_t> hashes;
  for (int run = 0; run < 2; ++run) {
    State state = initial_state(scene);
    Workspace workspace;
    advance(scene, options, state, workspace, 400);
    hashes.push_back(hash_of(state));
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST_P(StepWithRule, NeverEndsInsideAnObstacleThatItSlidesAlong) {
  const Scene scene = sliding_cube();
  State state = initial_state(scene);
  Workspace workspace;
  for (int k = 0; k < 400; ++k) {
    advance(scene, options, state, workspace, 1);
    for (const Position& position : state.position) {
      // On the ground to the round-off of 0.1 m; on the wall but for the ground's friction, which
      // comes after the wall's normal force and moves a vertex by at most μ gΔt² of its load.
      ASSERT_GT(position.x.z(), -1e-15);
      ASSERT_GT(position.x.x(), -0.01 - 1e-5);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rules, StepWithRule, testing::Values("none", "fixed-point"),
                         [](const auto& one) {
                           return one.param == "none" ? std::string("None")
                                                      : std::string("FixedPoint");
                         });

TEST(Step, WithoutAClockAddsNoTimeAndWithOneFillsEveryPhaseAndLeavesTheAnswer) {
  const Scene scene = sliding_cube();
  const Options options{.time_step = 2e-4};
  PhaseSeconds seconds{};
  State untimed = initial_state(scene);
  State timed = untimed;
  Workspace workspace;
  advance(scene, options, untimed, workspace, 100);
  EXPECT_EQ(seconds, PhaseSeconds{});
  Workspace with_clock;
  with_clock.phase_seconds = &seconds;
  advance(scene, options, timed, with_clock, 100);
  for (std::size_t p = 0; p < seconds.size(); ++p) {
    // A scene whose bodies cannot touch each other has no depths to find.
    if (static_cast<Phase>(p) == Phase::kDepth) {
      EXPECT_EQ(seconds[p], 0.0);
    } else {
      EXPECT_GT(seconds[p], 0.0) << kPhaseNames[p];
    }
  }
  EXPECT_EQ(hash_of(timed), hash_of(untimed));
}

TEST(Step, CountsStepsAndNeedsNothingOfWhatAWorkspaceHeld) {
  const Scene scene = sliding_cube();
  const Options options{.time_step = 2e-4};
  State clean = initial_state(scene);
  State dirty = clean;
  Workspace fresh;
  advance(scene, options, clean, fresh, 50);
  EXPECT_EQ(clean.step, 50u);

  Workspace used;
  used.force.assign(3, {Vec3::Constant(test::kNaN), test::kNaN});
  used.velocity.assign(40, {Vec3::Constant(test::kNaN), test::kNaN});
  used.contacts.add(7, 7, 7, test::kNaN);
  used.memory = {{1, 2}, {ContactStatus::kStick, ContactStatus::kStick}, {test::kNaN, test::kNaN}};
  advance(scene, options, dirty, used, 50);
  EXPECT_EQ(hash_of(dirty), hash_of(clean));
}

// A workspace that has seen contacts last puts those apart that share a vertex; a new one can't.
TEST(Step, HasTheSameBitsWhetherContactsStandApartOrNot) {
  SceneDescription description = test::stacked_cubes(1e-9);
  description.half_spaces = {test::ground(0.5)};
  description.gravity = {{0.0}, {Vec3(2.0, 0.0, -9.81)}};
  const Scene scene = build_scene(description);
  Options paper{.time_step = 1e-4, .rule = "fixed-point"};
  paper.pairs.gain = NormalGain::kPaper;
  paper.pairs.weights = PairWeights::kTriangle;
  paper.pairs.normals_first = false;
  for (const Options& options : {Options{.time_step = 1e-4}, paper}) {
    State kept = initial_state(scene), afresh = kept;
    Workspace workspace;
    advance(scene, options, kept, workspace, 30);
    EXPECT_GT(workspace.pairs.size(), 8u) << "that last";
    for (int k = 0; k < 30; ++k) {
      Workspace unused;
      advance(scene, options, afresh, unused, 1);
    }
    EXPECT_EQ(hash_of(kept), hash_of(afresh)) << options.rule;
  }
}

// What a workspace has of the last step's contacts is looked through, and left where it holds: it must not
// where partners were of a triangle, or elements of another scene had their corners in another order.
TEST(Step, TakesNothingFromAWorkspaceThatSawOtherOptionsOrAnotherScene) {
  SceneDescription description = test::stacked_cubes(1e-9);
  description.half_spaces = {test::ground(0.5)};
  description.gravity = {{0.0}, {Vec3(2.0, 0.0, -9.81)}};
  // So that contacts stay closed.
  description.bodies[1].initial_velocity = Vec3(0.0, 0.0, -10.0).replicate(1, 27);
  const Scene scene = build_scene(description);
  for (BodyDescription& body : description.bodies) {
    const auto corners = body.mesh.tetrahedra;
    for (int k = 0; k < 3; ++k) body.mesh.tetrahedra.row(k) = corners.row((k + 1) % 3);
  }
  const Scene renumbered = build_scene(description);
  const Options tetrahedron{.time_step = 1e-4};
  Options triangle = tetrahedron, by_triangle = tetrahedron;
  triangle.pairs.weights = by_triangle.pairs.weights = PairWeights::kTriangle;
  by_triangle.pairs.key = PairKey::kTriangle;
  struct Step {
    const Scene& scene;
    const Options& options;
  };
  State used = initial_state(scene), unused = used;
  Workspace workspace;
  std::ptrdiff_t closed = 0;
  for (int k = 0; k < 5; ++k) {
    for (const auto& [of, options] :
         {Step{scene, tetrahedron}, Step{renumbered, tetrahedron}, Step{renumbered, triangle},
          Step{renumbered, by_triangle}, Step{scene, triangle}}) {
      Workspace fresh;
      advance(of, options, used, workspace, 2);
      advance(of, options, unused, fresh, 2);
      for (std::size_t c = 0; c < workspace.pairs.size(); ++c) {
        closed += !workspace.pairs.site(c).open;
      }
      ASSERT_EQ(hash_of(used), hash_of(unused)) << k;
    }
  }
  EXPECT_GT(closed, 30);
}

// Contacts that last, some of them open, with a workspace that saw other options in the step before.
TEST(Step, TakesNoContactsOfOtherOptions) {
  SceneDescription description = test::stacked_cubes(1e-9);
  description.half_spaces = {test::ground(0.5)};
  description.gravity = {{0.0}, {Vec3(0.0, 0.0, -9.81)}};
  const Scene scene = build_scene(description);
  const Options usual{.time_step = 1e-4};
  Options forgetting = usual, by_triangle = usual;
  forgetting.pairs.hysteresis = 0.0;
  by_triangle.pairs.key = PairKey::kTriangle;
  State state = initial_state(scene);
  Workspace workspace;
  int lasted = 0;
  for (int k = 0; k < 60; ++k) {
    for (const Options& other : {forgetting, by_triangle}) {
      lasted += workspace.search.found_same;
      Workspace used = workspace;
      State of_used = state, of_fresh = state;
      for (const Options& options : {other, usual, usual}) {
        Workspace fresh;
        advance(scene, options, of_used, used, 1);
        advance(scene, options, of_fresh, fresh, 1);
        ASSERT_EQ(hash_of(of_used), hash_of(of_fresh)) << k;
      }
    }
    advance(scene, usual, state, workspace, 1);
  }
  EXPECT_GT(lasted, 60);
}

// Two cubes on the ground come to rest; the upper one is knocked sideways, down and up, and put back now and then
// to where it was. Where the contacts of the last step are taken for this one's, they are those that a new
// workspace finds.
TEST(Step, TakesTheContactsOfTheLastStepForItsOwnOnlyWhereTheyAre) {
  std::size_t taken = 0, most = 0, least = 1000;
  for (const double depth : {1e-9, 1e-6}) {
    SceneDescription description = test::stacked_cubes(depth);
    description.half_spaces = {test::ground(0.5)};
    description.gravity = {{0.0}, {Vec3(0.5, 0.0, -9.81)}};
    description.drag = {.rate = 2000.0, .full_until = 1.0, .ends = 2.0};
    const Scene scene = build_scene(description);
    const Options options{.time_step = 1e-4};
    State used = initial_state(scene), earlier = used;
    Workspace workspace;
    for (int k = 0; k < 1500; ++k) {
      if (k % 500 == 440) earlier = used;
      if (k % 500 == 450) {
        const Body& upper = scene.bodies[1];
        for (int v = upper.first_vertex; v < upper.first_vertex + upper.vertex_count; ++v) {
          used.velocity[static_cast<std::size_t>(v)].v +=
              Vec3(0.02, -0.006, k % 1000 == 450 ? -0.04 : 0.04);
        }
      }
      if (k % 10 == 5) used.pair_geometry = earlier.pair_geometry;  // of another moment
      if (k % 500 == 480) used = earlier;
      State unused = used;
      Workspace fresh;
      advance(scene, options, used, workspace, 1);
      advance(scene, options, unused, fresh, 1);
      ASSERT_EQ(hash_of(used), hash_of(unused)) << "step " << k;
      taken += workspace.search.found_same;
      most = std::max(most, workspace.pairs.size());
      least = std::min(least, workspace.pairs.size());
    }
  }
  EXPECT_GT(taken, 1000u);
  EXPECT_GT(most, least) << "contacts come and go";
}

// Exact-computed: vₙ = v₀ + n Δt g, xₙ = x₀ + Δt Σ vₖ.
TEST(Step, FollowsTheRecurrenceOfFreeFall) {
  SceneDescription description = test::one_body(test::point_masses(Vec3(1, 2, 3), 0.3));
  description.bodies[0].initial_velocity = Vec3(0.5, 0.0, 4.0);
  description.gravity = {{0.0}, {Vec3(0, 0, -9.81)}};
  const Scene scene = build_scene(description);
  State state = initial_state(scene);
  Workspace workspace;
  const int n = 1000;
  const double dt = 1e-3;
  advance(scene, {.time_step = dt}, state, workspace, n);
  const double fallen = 9.81 * dt * dt * n * (n + 1) / 2.0;
  // Four roundings a step of numbers below 8.
  EXPECT_NEAR(state.velocity[0].v.z(), 4.0 - 9.81 * n * dt, n * 4 * 4 * test::kEpsilon);
  EXPECT_NEAR(state.position[0].x.z(), 3.0 + 4.0 * n * dt - fallen, n * 4 * 4 * test::kEpsilon);
  EXPECT_NEAR(state.position[0].x.x(), 1.5, n * test::kEpsilon);
  EXPECT_EQ(state.velocity[0].v.x(), 0.5);
}

TEST(Step, ReadsGravityAtTheStartOfTheStep) {
  SceneDescription description = test::one_body(test::point_masses(Vec3::Zero(), 1.0));
  description.gravity = {{0.0, 1.0}, {Vec3::Zero(), Vec3(0, 0, -8)}};
  const Scene scene = build_scene(description);
  State state = initial_state(scene);
  Workspace workspace;
  advance(scene, {.time_step = 0.25}, state, workspace, 2);
  // g(0) = 0 and g(¼) = −8 · 53/512; powers of two, so nothing is rounded.
  EXPECT_EQ(state.velocity[0].v.z(), -0.25 * 8.0 * 53.0 / 512.0);
}

TEST(Step, KeepsLinearAndAngularMomentumOfAFreelyVibratingBody) {
  BodyDescription body = test::elastic_body(test::cube_mesh(2, 0.1), {1000.0, 1e5, 0.3, 1e-4});
  body.initial_velocity = test::noise(27, 0.5, 5);
  const Scene scene = build_scene(test::one_body(body));
  State state = initial_state(scene);
  const Vec3 linear = linear_momentum(scene, state);
  const Vec3 angular = angular_momentum(scene, state);
  const double kinetic = kinetic_energy(scene, state);
  Workspace workspace;
  const int n = 2000;
  advance(scene, {.time_step = 2e-4}, state, workspace, n);
  EXPECT_LT(kinetic_energy(scene, state), 0.5 * kinetic) << "it did vibrate";
  // Symplectic Euler keeps both exactly: ΔL = Δt Σ x_t0 × F(x_t0) = 0. Per step the force sums
  // round by some 100 ε of Σ|m v| ≈ 0.5 kg m/s in all 27 vertices, as a random walk over the steps.
  const double round_off = 100.0 * test::kEpsilon * 0.5 * std::sqrt(static_cast<double>(n));
  EXPECT_LT((linear_momentum(scene, state) - linear).norm(), round_off);
  EXPECT_LT((angular_momentum(scene, state) - angular).norm(), round_off);
}

TEST(Step, HoldsAPinnedVertexWhereItIs) {
  BodyDescription body = test::elastic_body(test::cube_mesh(1, 0.1), {1000.0, 1e5, 0.3, 1e-4});
  body.pinned = {0, 5};
  SceneDescription description = test::one_body(body);
  description.gravity = {{0.0}, {Vec3(0, 0, -9.81)}};
  const Scene scene = build_scene(description);
  State state = initial_state(scene);
  Workspace workspace;
  advance(scene, {.time_step = 2e-4}, state, workspace, 100);
  for (const std::size_t described : {0, 5}) {
    const auto v = static_cast<std::size_t>(scene.scene_vertex[described]);
    EXPECT_EQ(state.position[v].x, Vec3(scene.rest_position.col(static_cast<Eigen::Index>(v))));
  }
  EXPECT_LT(centre_velocity(scene, state, scene.bodies[0]).z(), -1e-3) << "the others hang";
}

// A point mass on the ground under a load below the cone stays put, exactly; above it, it slides.
TEST(Step, LetsAPointMassStickBelowTheConeAndSlideAboveIt) {
  for (const double tangential : {4.9, 5.1}) {
    SceneDescription description = test::one_body(test::point_masses(Vec3::Zero(), 1.0));
    description.half_spaces = {test::ground(0.5)};
    description.gravity = {{0.0}, {Vec3(tangential, 0, -10)}};
    const Scene scene = build_scene(description);
    State state = initial_state(scene);
    Workspace workspace;
    const double dt = 1e-3;
    advance(scene, {.time_step = dt, .rule = "none"}, state, workspace, 1000);
    const double expected = tangential < 5.0 ? 0.0 : 1000 * dt * (tangential - 5.0);
    // Ten roundings a step of gΔt = 1e-2 m/s while it sticks, of up to 0.1 m/s while it slides.
    EXPECT_NEAR(state.velocity[0].v.x(), expected, 1000 * 10 * 1e-2 * test::kEpsilon);
  }
}

}  // namespace
}  // namespace stiction
