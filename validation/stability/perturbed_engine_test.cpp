// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/stability/perturbed_engine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cfenv>

#include "reference/process/child.h"
#include "solver/demand.h"
#include "validation/engines/stiction/solver_view.h"
#include "validation/problems/free_boxes.h"
#include "validation/problems/slopes/incline_problem.h"
#include "validation/problems/slopes/slab_problem.h"

namespace stiction {
namespace {

using testing::HasSubstr;

// A scene with all that a frame has to turn: two bodies, an obstacle, gravity over time, a couple, a
// spring, spin.
Problem rich_problem() {
  SlabSetup setup;
  setup.slope = 0.2;
  setup.cells = 2;
  Problem problem = slab_problem(setup);
  problem.bodies[0].position.z() += 1e-4;
  problem.bodies[0].velocity = {0.1, -0.05, 0.02};
  problem.bodies[0].angular_velocity = {0.3, 0.2, -0.4};
  problem.obstacles = {
      {.name = "wall", .point = {0.3, 0, 0}, .normal = {-1, 0, 0}, .friction = 0.3}};
  problem.loads = {{.body = 0,
                    .force = {{0.0}, {Vec3(0.1, 0.2, 0.3)}},
                    .couple = {{0.0}, {Vec3(0.01, -0.02, 0.03)}}}};
  problem.springs = {{.body = 0, .anchor = {0.1, 0, 0}, .axis = {0, 1, 0}, .stiffness = 20.0}};
  return problem;
}

std::unique_ptr<Engine> after(const std::string& perturbation, std::uint64_t steps) {
  const EngineKind plain = find_engine("stiction");
  const EngineKind kind =
      perturbation.empty() ? plain : perturbed(plain, find_perturbation(perturbation));
  std::unique_ptr<Engine> engine = kind.make({{"method", "quiet"}});
  engine->load(rich_problem(), {.time = 1e-4});
  engine->advance(steps);
  return engine;
}

class EachFrame : public testing::TestWithParam<std::string> {};

// What comes of the dynamics agrees to the digits that a few steps leave; a sign or a factor that is
// wrong is seen at once.
TEST_P(EachFrame, TellsWhatItSeesAsItIsHere) {
  const auto here = after("", 40), there = after(GetParam(), 40);
  EXPECT_NEAR(there->time_step(), here->time_step(), 1e-15);
  for (std::size_t b = 0; b < 2; ++b) {
    const BodyMotion a = here->body(b), c = there->body(b);
    EXPECT_LT((a.position - c.position).norm(), 1e-8);
    EXPECT_LT((a.velocity - c.velocity).norm(), 1e-6);
    EXPECT_LT((a.angular_velocity - c.angular_velocity).norm(), 1e-4);
    EXPECT_LT(a.rotation.angularDistance(c.rotation), 1e-7);
  }
  const Momenta p = here->momenta(), q = there->momenta();
  EXPECT_LT((p.linear - q.linear).norm(), 1e-6);
  EXPECT_LT((p.angular - q.angular).norm(), 1e-6);
  const Energies e = here->energies(), f = there->energies();
  EXPECT_NEAR(e.kinetic, f.kinetic, 1e-6);
  EXPECT_NEAR(e.elastic, f.elastic, 1e-6);
  // Its zero is arbitrary, but stays where it is.
  const auto begun = after("", 0), begun_there = after(GetParam(), 0);
  EXPECT_NEAR(e.gravity - begun->energies().gravity, f.gravity - begun_there->energies().gravity,
              1e-6);
  const auto contacts = here->contacts(), seen = there->contacts();
  ASSERT_EQ(contacts.size(), seen.size());
  Vec3 force = Vec3::Zero(), force_seen = force, place = force, place_seen = force;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const auto add = [](const ContactSample& one, Vec3& sum, Vec3& at) {
      const double sign = one.body == 0 ? 1.0 : -1.0;
      sum += sign * (one.normal_force * one.normal + one.friction_force);
      at += one.position;
    };
    add(contacts[c], force, place);
    add(seen[c], force_seen, place_seen);
  }
  EXPECT_LT((force - force_seen).norm(), 1e-3);
  EXPECT_LT((place - place_seen).norm(), 1e-6);
  EXPECT_LT((here->vertices(0) - there->vertices(0)).colwise().norm().minCoeff(), 1e-7);
}

INSTANTIATE_TEST_SUITE_P(Perturbations, EachFrame,
                         testing::Values("turned/2", "turned/3", "moved/1", "moved/1000",
                                         "mirrored", "bodies/1", "vertices/1", "units", "drifting",
                                         "ulp/1", "rounding/upward"),
                         [](const auto& one) {
                           std::string name = one.param;
                           for (char& sign : name) sign = std::isalnum(sign) ? sign : '_';
                           return name;
                         });

TEST(PerturbedEngine, WithoutPerturbationIsTheEngine) {
  EXPECT_EQ(after("", 40)->state_hash(), after("rerun", 40)->state_hash());
  EXPECT_EQ(after("", 40)->body(0).position, after("rerun", 40)->body(0).position);
}

TEST(PerturbedEngine, LeavesTheThreadsRoundingAsItWas) {
  const int before = std::fegetround();
  const auto engine = after("rounding/downward", 3);
  EXPECT_EQ(std::fegetround(), before);
  EXPECT_NE(engine->state_hash(), after("", 3)->state_hash()) << "it did round otherwise";
}

// As what is of this build rounds, to the last bit.
TEST(PerturbedEngine, TellsAProgramOfTheKitHowToRound) {
  const auto program = reference::folder_of_this_program() / "hosted_engine";
  const auto after = [](const std::string& engine, const std::string& perturbation) {
    const auto made = perturbed(find_engine(engine), find_perturbation(perturbation)).make({});
    made->load(incline_problem({}), {});
    made->advance(50);
    return made->body(0);
  };
  for (const char* const how : {"rounding/upward", "rounding/downward", "rounding/toward-zero"}) {
    const BodyMotion there = after(program.string(), how), here = after("stiction", how);
    EXPECT_EQ(there.position, here.position) << how;
    EXPECT_EQ(there.velocity, here.velocity) << how;
    EXPECT_NE(there.position, after(program.string(), "rerun").position) << how;
  }
}

TEST(PerturbedEngine, RefusesToRoundAProgramThatCannotBeToldSo) {
  EngineKind program = find_engine("stiction");
  program.program = "python3 my_engine.py";
  try {
    perturbed(program, find_perturbation("rounding/upward"));
    FAIL();
  } catch (const NotApplicable& reason) {
    EXPECT_THAT(reason.what(), HasSubstr("no setting 'rounding'"));
  }
}

TEST(PerturbedEngine, TakesEachStepBackAndAgain) {
  const auto trace = std::make_shared<PerturbedTrace>();
  {
    const EngineKind kind = perturbed(find_engine("stiction"), find_perturbation("rewind"), trace);
    const auto engine = kind.make({{"method", "paper"}});
    engine->load(rich_problem(), {});
    engine->advance(25);
    EXPECT_EQ(engine->steps_done(), 25u);
  }
  EXPECT_EQ(trace->rewound, 25u);
  EXPECT_EQ(trace->unlike, 0u);
  ASSERT_EQ(trace->ends.size(), 1u);
  EXPECT_EQ(trace->ends[0].bodies.size(), 2u);
  EXPECT_EQ(trace->ends[0].steps, 25u);
}

// Says so where it cannot: what would be measured would be another thing.
TEST(PerturbedEngine, IsNotApplicableWhereItCannotBe) {
  const EngineKind stiction = find_engine("stiction"), plain = find_engine("plain");
  EXPECT_THROW(perturbed(plain, find_perturbation("single")), NotApplicable);
  const EngineKind units = perturbed(stiction, find_perturbation("units"));
  EXPECT_THROW(units.make({{"dt", "1e-4"}}), NotApplicable);
  Problem alone = incline_problem({});
  alone.obstacles.clear();
  EXPECT_THROW(perturbed(alone, find_perturbation("bodies/1"), 1), NotApplicable);
  EXPECT_THROW(perturbed(alone, find_perturbation("ulp/1"), 1).problem.name.at(99),
               std::out_of_range);
  Problem damped = incline_problem({});
  damped.drag = {.rate = 1.0, .full_until = 1.0, .ends = 2.0};
  EXPECT_THROW(perturbed(damped, find_perturbation("drifting"), 1), NotApplicable);
}

// Nor is what looks into the solver, past the wrapper.
TEST(PerturbedEngine, HidesTheSolver) {
  const auto engine = perturbed(find_engine("stiction"), find_perturbation("ulp/1")).make({});
  EXPECT_THROW(solver_view(*engine), NotApplicable);
}

TEST(Perturbations, HaveNamesOfTheirOwnAndAGroup) {
  std::set<std::string> names;
  for (const Perturbation& one : perturbations()) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_FALSE(one.words.empty()) << one.name;
  }
  for (const PerturbationGroup& group : perturbation_groups()) {
    EXPECT_TRUE(group.against.empty() || names.count(group.against) == 1) << group.name;
    EXPECT_TRUE(std::any_of(perturbations().begin(), perturbations().end(),
                            [&](const Perturbation& one) { return one.group == group.name; }))
        << group.name;
    EXPECT_LE(group.at_rest, group.tolerance);
  }
  EXPECT_THROW(find_perturbation("turned"), InputError);
}

TEST(Noise, MovesEachNumberByAUnitInTheLastPlaceAtMost) {
  const Problem problem = rich_problem();
  const Problem there = perturbed(problem, find_perturbation("ulp/3"), 1).problem;
  const auto near = [](double a, double b) { return a == b || std::nextafter(a, b) == b; };
  int moved = 0;
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    for (int axis = 0; axis < 3; ++axis) {
      const double x = problem.bodies[b].position[axis], y = there.bodies[b].position[axis];
      EXPECT_TRUE(near(x, y));
      moved += x != y;
    }
    EXPECT_TRUE(near(problem.bodies[b].mass, there.bodies[b].mass));
    moved += problem.bodies[b].mass != there.bodies[b].mass;
  }
  EXPECT_GT(moved, 0);
}

}  // namespace
}  // namespace stiction
