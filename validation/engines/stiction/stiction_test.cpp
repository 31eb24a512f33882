// SPDX-License-Identifier: GPL-3.0-or-later
// The adapter of this project's solver, through the interface that every engine has.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/friction/catalog.h"
#include "solver/testing/test_refusal.h"
#include "solver/workspace.h"
#include "validation/engine/engine.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {
namespace {

using testing::HasSubstr;

std::unique_ptr<Engine> loaded(const Problem& problem, const Settings& settings = {}) {
  std::unique_ptr<Engine> engine = find_engine("stiction").make(settings);
  engine->load(problem, {});
  return engine;
}

InclineSetup slope(double tan_slope, double speed = 0.0) {
  InclineSetup setup;
  setup.tan_slope = tan_slope;
  setup.azimuth = 0.5;
  setup.speed = speed;
  return setup;
}

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

TEST(StictionEngine, ResolvesItsSettings) {
  const Problem problem = incline_problem(slope(0.3));
  EXPECT_EQ(loaded(problem)->settings(), (Settings{{"rule", "conjugate-vector"},
                                                   {"sweeps", "64"},
                                                   {"slip-tolerance", "1e-07"},
                                                   {"dt", "0.0002"},
                                                   {"cells", "2"}}));
  EXPECT_EQ(loaded(problem, {{"rule", "fixed-point"}})->settings(),
            (Settings{{"rule", "fixed-point"},
                      {"dt", "0.0002"},
                      {"cells", "2"},
                      {"gain", "0.7"},
                      {"memory", "reset"}}));
  EXPECT_EQ(loaded(problem, {{"rule", "none"}, {"dt", "1e-4"}, {"cells", "1"}})->settings(),
            (Settings{{"rule", "none"}, {"dt", "0.0001"}, {"cells", "1"}}));
  EXPECT_EQ(loaded(problem, {{"rule", "fixed-point"}, {"alpha", "-0.1"}})->settings(),
            (Settings{{"rule", "fixed-point"},
                      {"dt", "0.0002"},
                      {"cells", "2"},
                      {"alpha", "-0.1"},  // in place of the gain
                      {"memory", "reset"}}));
}

// A value that is allowed and not the default.
double another(const RuleParameter& parameter) {
  if (parameter.off) return 1.0 - parameter.initial;
  for (const double value : {0.5, 1.5, 2.0 * parameter.initial, 1.0 + parameter.initial,
                             0.5 * (parameter.low + parameter.high)}) {
    if (value != parameter.initial && refusal_of(parameter, value).empty()) return value;
  }
  ADD_FAILURE() << "no other value of " << parameter.name;
  return parameter.initial;
}

std::string text_of(const RuleParameter& parameter, double value) {
  if (parameter.off) return value != 0.0 ? parameter.on : parameter.off;
  return fmt::format("{}", value);
}

// What a rule declares of a parameter in its header is all there is of it.
TEST(StictionEngine, TakesTellsAndRefusesTheParametersOfEachRule) {
  const EngineKind kind = find_engine("stiction");
  const Problem problem = incline_problem(slope(0.3));
  for (const std::string& rule : friction_rule_names()) {
    const Settings usual = loaded(problem, {{"rule", rule}})->settings();
    for (const RuleParameter& one : friction_rule_parameters(rule)) {
      SCOPED_TRACE(rule + ", " + one.name);
      EXPECT_THAT(kind.settings_help.at(one.name), HasSubstr(one.help));
      EXPECT_THAT(kind.settings_help.at(one.name), HasSubstr(rule));
      EXPECT_EQ(usual.count(one.name), one.told_when_set ? 0u : 1u);
      const double value = another(one);
      const std::string text = text_of(one, value);
      const Settings told = loaded(problem, {{"rule", rule}, {one.name, text}})->settings();
      EXPECT_EQ(told.at(one.name), text);
      if (one.replaces) {
        EXPECT_EQ(told.count(one.replaces), 0u);
      }
      const std::string refused = test::refusal([&] {
        kind.make({{"rule", rule}, {one.name, "much"}});
      });
      EXPECT_THAT(refused, HasSubstr(one.name));
      if (std::isfinite(one.low)) {
        const std::string low = fmt::format("{}", one.low - 1.0);
        EXPECT_EQ(test::refusal([&] {
                    kind.make({{"rule", rule}, {one.name, low}});
                  }),
                  fmt::format("rule '{}': '{}' must be {}, not {}", rule, one.name,
                              range_words(one), low));
      }
    }
    for (const std::string& other : friction_rule_names()) {
      for (const RuleParameter& one : friction_rule_parameters(other)) {
        const auto own = friction_rule_parameters(rule);
        const bool has = std::any_of(own.begin(), own.end(), [&](const RuleParameter& mine) {
          return std::string(mine.name) == one.name;
        });
        const auto idle = kind.idle({{"rule", rule}, {one.name, text_of(one, another(one))}});
        EXPECT_EQ(idle.count(one.name), has ? 0u : 1u) << rule << ", " << one.name;
      }
    }
  }
}

TEST(StictionEngine, RefusesUnknownSettingsWhenItIsMade) {
  EXPECT_EQ(
      test::refusal([] {
        find_engine("stiction").make({{"sped", "1"}});
      }),
      "engine 'stiction' has no setting 'sped'; there are: alpha, ball, border, bound, cells, "
      "count-hysteresis, depth, depth-noise, dt, edges, face, gain, hysteresis, integrator, kappa, "
      "key, memory, "
      "method, normals, order, "
      "post-correction, reaction, relaxation, rule, safeguard, slip-tolerance, sweeps, tie, "
      "weights");
}

TEST(StictionEngine, SaysWhyASettingHasNoEffect) {
  const auto idle = find_engine("stiction").idle;
  const auto sentences = idle({{"method", "old"}, {"gain", "0.6"}, {"memory", "keep"}});
  ASSERT_EQ(sentences.size(), 2u);
  EXPECT_EQ(sentences.at("gain"), "rule 'none' has no parameter 'gain'; it has none");
  EXPECT_EQ(idle({{"gain", "0.6"}}).at("gain"),
            "rule 'conjugate-vector' has no parameter 'gain'; it has relaxation, slip-tolerance");
  EXPECT_TRUE(idle({{"method", "paper"}, {"gain", "0.6"}, {"kappa", "1"}}).empty());
}

TEST(StictionEngine, RefusesWhatIsOutOfRangeWhenItIsMade) {
  const auto refused = [](const Settings& settings) {
    return test::refusal([&] { find_engine("stiction").make(settings); });
  };
  EXPECT_EQ(refused({{"slip-tolerance", "-3"}}),
            "rule 'conjugate-vector': 'slip-tolerance' must be at least 0, not -3");
  EXPECT_EQ(refused({{"tie", "1"}}), "the tie margin must lie in [0, 1), not 1");
  EXPECT_EQ(refused({{"dt", "-1"}}), "the time step must be positive and finite, not -1 s");
}

TEST(StictionEngine, ShortensTheDefaultStepWhereStabilityAsksForIt) {
  InclineSetup stiff = slope(0.3);
  stiff.elasticity.youngs_modulus = 5e7;
  stiff.elasticity.damping_time = 0.0;
  const double dt = loaded(incline_problem(stiff))->time_step();
  EXPECT_LT(dt, 2e-4);
  // One of 1, 2, 5 × 10ⁿ, and not more than a factor 2.5 below 80 % of the limit.
  const double mantissa = dt / std::pow(10.0, std::floor(std::log10(dt * (1.0 + 1e-9))));
  EXPECT_LT(
      std::min({std::abs(mantissa - 1.0), std::abs(mantissa - 2.0), std::abs(mantissa - 5.0)}),
      1e-9)
      << dt;
  const auto accepts = [&](double step) {
    return test::refusal([&] {
             loaded(incline_problem(stiff), {{"dt", std::to_string(step)}});
           })
        .empty();
  };
  EXPECT_TRUE(accepts(dt / 0.81)) << "80 % of the limit";
  EXPECT_FALSE(accepts(dt * 2.5 / 0.79)) << "and no smaller than need be";
}

TEST(StictionEngine, NamesTheLimitAndTheElementOfATooLongStep) {
  const std::string sentence = test::refusal([] {
    loaded(incline_problem(slope(0.3)), {{"dt", "0.01"}});
  });
  EXPECT_THAT(sentence, HasSubstr("the time step 0.01 s is above the stability limit"));
  EXPECT_THAT(sentence, HasSubstr("set by tetrahedron"));
  EXPECT_THAT(sentence, HasSubstr("(body 'box')"));
}

TEST(StictionEngine, RefusesAMassThatIsNotPositive) {
  for (const double mass : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    Problem problem = incline_problem(slope(0.3));
    problem.bodies[0].mass = mass;
    EXPECT_THAT(test::refusal([&] { loaded(problem); }),
                HasSubstr("body 'box': mass must be positive and finite"));
  }
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
  EXPECT_GT(cost.ns_per_contact_update, 0.0);
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
