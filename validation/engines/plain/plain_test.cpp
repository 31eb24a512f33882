// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "solver/demand.h"
#include "validation/engine/engine.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {
namespace {

constexpr double kAngle = 0.3;  // rad

std::unique_ptr<Engine> on_slope(double friction, double speed, const Settings& settings = {}) {
  InclineSetup setup;
  setup.tan_slope = std::tan(kAngle);
  setup.friction = friction;
  setup.speed = speed;
  auto engine = find_engine("plain").make(settings);
  engine->load(incline_problem(setup), {});
  return engine;
}

double speed(const Engine& engine) { return engine.body(0).velocity.norm(); }

TEST(Plain, SlidesWithTheDifferenceOfWeightAndFriction) {
  const auto engine = on_slope(0.2, 1.0);
  engine->advance(1000);
  const double gained = 0.2 * kStandardGravity * (std::sin(kAngle) - 0.2 * std::cos(kAngle));
  EXPECT_NEAR(speed(*engine), 1.0 + gained, 1e-12);
}

TEST(Plain, SticksOnAFlatterSlopeThanFrictionHolds) {
  const auto engine = on_slope(0.5, 0.0);
  const Vec3 start = engine->body(0).position;
  engine->advance(5000);
  EXPECT_LT((engine->body(0).position - start).norm(), 1e-15);
  ASSERT_EQ(engine->contacts().size(), 1u);
  const ContactSample contact = engine->contacts()[0];
  EXPECT_TRUE(contact.sticks);
  EXPECT_NEAR(contact.normal_force, kStandardGravity * std::cos(kAngle), 1e-9);
  EXPECT_NEAR(contact.friction_force.norm(), kStandardGravity * std::sin(kAngle), 1e-9);
}

TEST(Plain, CreepsWhereToldTo) {
  const auto engine = on_slope(0.5, 0.0, {{"creep", "1e-3"}});
  engine->advance(5000);
  EXPECT_NEAR(speed(*engine), 1e-3 * std::tan(kAngle) / 0.5, 1e-12);
}

TEST(Plain, GoesOnFromASnapshotAsBefore) {
  const auto engine = on_slope(0.2, 1.0);
  engine->advance(10);
  const Snapshot snapshot = engine->save();
  engine->advance(10);
  const std::uint64_t hash = engine->state_hash();
  engine->restore(snapshot);
  engine->advance(10);
  EXPECT_EQ(engine->state_hash(), hash);
}

TEST(Plain, RefusesWhatCannotBe) {
  const EngineKind kind = find_engine("plain");
  EXPECT_THROW(kind.make({{"dt", "0"}}), InputError);
  EXPECT_THROW(kind.make({{"creep", "-1"}}), InputError);
  EXPECT_THROW(kind.make({{"rule", "none"}}), InputError);
  Problem problem = incline_problem({});
  problem.bodies[0].mass = -1.0;
  EXPECT_THROW(kind.make({})->load(problem, {}), InputError);
}

TEST(Missing, NamesEachFeatureOnceInWords) {
  const EngineKind plain = find_engine("plain"), full = find_engine("stiction");
  Problem problem = incline_problem({});
  EXPECT_EQ(missing(plain.manifest, problem), "");
  problem.bodies[0].must_deform = true;
  problem.bodies[0].held = HeldPart{};
  problem.bodies.push_back(problem.bodies[0]);
  problem.drag.rate = 1.0;
  problem.obstacles[0].motion.time = {0.0};
  EXPECT_EQ(missing(plain.manifest, problem),
            "bodies that deform, held parts, contact between bodies, moving obstacles, a medium "
            "that damps");
  EXPECT_EQ(missing(full.manifest, problem), "");
}

}  // namespace
}  // namespace stiction
