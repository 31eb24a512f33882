// SPDX-License-Identifier: GPL-3.0-or-later
// The adapter of this project's solver, through the interface that every engine has.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/friction/catalog.h"
#include "solver/testing/test_refusal.h"
#include "solver/workspace.h"
#include "validation/engines/stiction/test_engine.h"

namespace stiction {
namespace {

using test::loaded;
using test::slope;
using testing::HasSubstr;

void advance_to(Engine& engine, double time) {
  engine.advance(static_cast<std::uint64_t>(std::llround(time / engine.time_step())) -
                 engine.steps_done());
}

struct ContactSums {
  double normal_force = 0.0;
  double friction_downhill = 0.0;
};

ContactSums sums(const Engine& engine, const InclineFrame& frame) {
  ContactSums all;
  for (const ContactSample& contact : engine.contacts()) {
    all.normal_force += contact.normal_force;
    all.friction_downhill += contact.friction_force.dot(frame.downhill);
  }
  return all;
}

TEST(StictionEngine, SaysWhatItIs) {
  const EngineKind kind = find_engine("stiction");
  EXPECT_TRUE(kind.manifest.deformable);
  EXPECT_TRUE(kind.manifest.point_masses);
  EXPECT_TRUE(kind.manifest.snapshots);
  for (const char* name : {"rule", "gain", "alpha", "dt", "cells"}) {
    EXPECT_EQ(kind.settings_help.count(name), 1u) << name;
  }
}

// Divergence theorem: Σ x₀·(x₁ × x₂)/6 over outward triangles.
TEST(StictionEngine, ShowsAClosedOutwardSurface) {
  Problem problem = incline_problem(slope(0.3));
  problem.bodies[0].shape = BallShape{0.1};
  problem.obstacles.clear();
  const auto engine = loaded(problem, {{"ball", "16"}});
  const Eigen::Matrix3Xi surface = engine->surface(0);
  const Eigen::Matrix3Xd vertices = engine->vertices(0);
  double volume = 0.0;
  for (Eigen::Index t = 0; t < surface.cols(); ++t) {
    const Vec3 a = vertices.col(surface(0, t));
    const Vec3 b = vertices.col(surface(1, t));
    volume += a.dot(b.cross(vertices.col(surface(2, t)))) / 6.0;
  }
  EXPECT_NEAR(volume, 4.0 / 3.0 * M_PI * 1e-3, 2e-5);
}

TEST(StictionEngine, StandsAtItsStartAfterLoading) {
  const Problem problem = incline_problem(slope(0.3, 2.0));
  const auto engine = loaded(problem);
  EXPECT_EQ(engine->steps_done(), 0u);
  EXPECT_TRUE(engine->contacts().empty());
  // 27 vertices of unequal mass: round-off of their mean.
  EXPECT_LT((engine->body(0).position - problem.bodies[0].position).norm(), 1e-15);
  EXPECT_LT((engine->body(0).velocity - problem.bodies[0].velocity).norm(), 1e-14);
  EXPECT_NEAR(engine->energies().kinetic, 0.5 * 1.0 * 4.0, 1e-14);
  EXPECT_EQ(engine->kinetic_energy(), engine->energies().kinetic);
  EXPECT_NEAR(engine->energies().elastic, 0.0, 1e-20);
  EXPECT_EQ(engine->cost().steps, 0u);
}

TEST(StictionEngine, ShowsContactsOfARestingBoxThatCarryItsWeightAndShear) {
  const InclineSetup setup = slope(0.3);
  const InclineFrame frame = incline_frame(setup);
  const auto engine = loaded(settled_incline_problem(setup));
  advance_to(*engine, 1.4);
  const double cosine = 1.0 / std::hypot(1.0, 0.3);
  // Vibrations have decayed by then, as in half-space/rest.
  EXPECT_NEAR(sums(*engine, frame).normal_force, kStandardGravity * cosine, 1e-6);
  EXPECT_NEAR(sums(*engine, frame).friction_downhill, -kStandardGravity * 0.3 * cosine, 1e-6);
  ASSERT_EQ(engine->contacts().size(), 9u) << "3 × 3 vertices of the lower face";
  for (const ContactSample& contact : engine->contacts()) {
    EXPECT_EQ(contact.body, 0u);
    EXPECT_EQ(contact.obstacle, 0u);
    EXPECT_EQ(contact.normal, frame.normal);
    EXPECT_GE(contact.normal_force, 0.0);
    EXPECT_LE(contact.friction_force.norm(), 0.5 * contact.normal_force);
    EXPECT_NEAR(contact.gap, 0.0, 1e-15);
    EXPECT_LT(contact.slip.norm(), 1e-9);
    EXPECT_TRUE(contact.sticks);
  }
}

TEST(StictionEngine, ShowsContactsOfASlidingBoxOnTheConeAgainstTheSlip) {
  const InclineSetup setup = slope(0.6, 1.0);
  const InclineFrame frame = incline_frame(setup);
  const auto engine = loaded(incline_problem(setup));
  advance_to(*engine, 0.1);
  ASSERT_FALSE(engine->contacts().empty());
  for (const ContactSample& contact : engine->contacts()) {
    EXPECT_FALSE(contact.sticks);
    EXPECT_GT(contact.slip.dot(frame.downhill), 0.5);
    EXPECT_NEAR(contact.slip.dot(frame.normal), 0.0, 1e-15);
    EXPECT_NEAR(contact.friction_force.dot(frame.normal), 0.0, 1e-13);
    EXPECT_NEAR(contact.friction_force.norm(), 0.5 * contact.normal_force,
                1e-14 * contact.normal_force);
    EXPECT_NEAR(contact.friction_force.dot(contact.slip),
                -contact.friction_force.norm() * contact.slip.norm(), 1e-12 * contact.normal_force)
        << "opposite to the slip";
  }
}

TEST(StictionEngine, TellsBodiesAndObstaclesApart) {
  Problem problem;
  for (const double x : {-1.0, 1.0}) {
    ProblemBody body;
    body.name = x < 0 ? "left" : "right";
    body.shape = PointShape{};
    body.mass = 2.0 + x;  // 1 kg and 3 kg
    body.position = Vec3(x, 0, x < 0 ? 0.0 : 1.0);
    problem.bodies.push_back(body);
  }
  // The right one stands on a table of its own.
  problem.obstacles = {{"floor", Vec3::Zero(), Vec3::UnitZ(), 0.1},
                       {"wall", Vec3(1, 0, 0), -Vec3::UnitX(), 0.1}};
  problem.gravity = {{0.0}, {Vec3(10, 0, -10)}};
  const auto engine = loaded(problem, {{"dt", "1e-3"}});
  engine->advance(1);
  ASSERT_EQ(engine->contacts().size(), 2u);
  EXPECT_EQ(engine->contacts()[0].body, 0u);
  EXPECT_EQ(engine->contacts()[0].obstacle, 0u);
  EXPECT_NEAR(engine->contacts()[0].normal_force, 10.0, 1e-9);
  EXPECT_EQ(engine->contacts()[1].body, 1u);
  EXPECT_EQ(engine->contacts()[1].obstacle, 1u);
  EXPECT_NEAR(engine->contacts()[1].normal_force, 30.0, 1e-6);  // beside a position of 1 m
}

TEST(StictionEngine, RestoresASavedStateToTheSameHashAndReplaysIt) {
  // Saved while it slips, so that memory and contacts differ between save and restore.
  const auto engine = loaded(incline_problem(slope(0.3, 0.05)));
  advance_to(*engine, 0.01);
  const Snapshot snapshot = engine->save();
  const std::uint64_t saved = engine->state_hash();
  const std::uint64_t steps = engine->steps_done();
  engine->advance(300);
  const std::uint64_t later = engine->state_hash();
  EXPECT_NE(later, saved);

  engine->restore(snapshot);
  EXPECT_EQ(engine->state_hash(), saved);
  EXPECT_EQ(engine->steps_done(), steps);
  engine->advance(300);
  EXPECT_EQ(engine->state_hash(), later);
  engine->restore(snapshot);
  EXPECT_EQ(engine->state_hash(), saved) << "a snapshot can be used again";
}

TEST(StictionEngine, GivesTheSameHashHoweverItsStepsAreCut) {
  const Problem problem = incline_problem(slope(0.3, 0.05));
  const auto whole = loaded(problem);
  whole->advance(100);
  const auto cut = loaded(problem);
  for (const int steps : {1, 0, 49, 50}) cut->advance(static_cast<std::uint64_t>(steps));
  EXPECT_EQ(cut->state_hash(), whole->state_hash());
  EXPECT_EQ(cut->steps_done(), 100u);
}

TEST(StictionEngine, BillsStepsContactsAndPhases) {
  const auto engine = loaded(incline_problem(slope(0.3)));
  engine->advance(64);
  const Cost cost = engine->cost();
  EXPECT_EQ(cost.steps, 64u);
  EXPECT_GT(cost.contact_updates, 64u * 3u);
  EXPECT_LE(cost.contact_updates, 64u * 9u);
  EXPECT_GT(cost.cpu_seconds, 0.0);
  EXPECT_GT(cost.contact_phases.median, 0.0);
  for (const ContactTime& time : {cost.contact_phases, cost.whole_step}) {
    EXPECT_LE(time.lower, time.median);
    EXPECT_LE(time.median, time.upper);
  }
  EXPECT_GT(cost.whole_step.median, cost.contact_phases.median);
  EXPECT_EQ(cost.phase_seconds.size(), kPhaseNames.size());
}

TEST(StictionEngine, SaysWhenItDiverged) {
  Problem problem = incline_problem(slope(0.0));
  problem.bodies[0].shape = PointShape{};
  problem.bodies[0].position = Vec3(1e308, 0, 1);
  problem.bodies[0].velocity = Vec3(1.7e308, 0, 0);  // overflows after 0.5 s
  const auto engine = loaded(problem, {{"dt", "1e-3"}});
  EXPECT_THAT(test::refusal([&] { engine->advance(1000); }),
              HasSubstr("the simulation diverged before t = "));
}

// A cube of 0.1 m over a plate that is held, at a speed downwards.
Problem thrown(double thickness, double speed) {
  Problem problem;
  ProblemBody plate;
  plate.name = "plate";
  plate.shape = BoxShape{Vec3(0.2, 0.2, thickness)};
  plate.elasticity = {.youngs_modulus = 1e5, .poisson_ratio = 0.3};
  plate.held = HeldPart{Vec3(0.0, 0.0, -0.5 * thickness), Vec3::UnitZ()};
  ProblemBody cube;
  cube.name = "cube";
  cube.shape = BoxShape{Vec3::Constant(0.1)};
  cube.elasticity = {.youngs_modulus = 1e5, .poisson_ratio = 0.3};
  cube.position = Vec3(0.01, 0.02, 0.5 * thickness + 0.06);
  cube.velocity = Vec3(0.0, 0.0, -speed);
  problem.bodies = {plate, cube};
  return problem;
}

TEST(StictionEngine, RefusesInWordsWhatPassesThrough) {
  const auto engine = loaded(thrown(0.02, 60.0));
  EXPECT_THAT(test::refusal([&] { engine->advance(100); }), HasSubstr("it is passing through"));
}

TEST(StictionEngine, RefusesInWordsWhatAStepCouldCarryThrough) {
  const auto engine = loaded(thrown(0.02, 900.0));
  const std::string words = test::refusal([&] { engine->advance(100); });
  EXPECT_THAT(words, HasSubstr("come at each other by "));
  EXPECT_THAT(words, HasSubstr("the time step must be below "));
}

TEST(StictionEngine, ShowsContactsOfCrossingEdges) {
  Problem problem;
  for (int k = 0; k < 2; ++k) {
    ProblemBody bar;
    bar.name = k == 0 ? "lower" : "upper";
    bar.shape = BoxShape{Vec3(0.4, 0.1, 0.1)};
    bar.position = Vec3(0.0, 0.0, 0.1 * k);
    if (k == 0) {
      bar.held = HeldPart{Vec3(0.0, 0.0, -0.05), Vec3::UnitZ()};
    } else {
      bar.rotation = Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitZ());
    }
    problem.bodies.push_back(bar);
  }
  problem.friction = 0.5;
  problem.gravity = {{0.0}, {Vec3(0.0, 0.0, -kStandardGravity)}};
  const auto engine = loaded(problem, {{"cells", "1"}});
  advance_to(*engine, 0.5);
  const std::vector<ContactSample> contacts = engine->contacts();
  ASSERT_EQ(contacts.size(), 4u) << "no vertex of one lies in the other";
  for (const ContactSample& contact : contacts) {
    EXPECT_TRUE(contact.against_body);
    EXPECT_GT(std::abs(contact.normal.z()), 0.99);
    EXPECT_LT(contact.arm.norm(), 1e-12) << "force and reaction act at one point";
  }
}

}  // namespace
}  // namespace stiction
