// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engine/engine.h"

#include <gtest/gtest.h>

#include "validation/core/case_run.h"
#include "validation/core/runner.h"
#include "validation/engine/protocol/problem_json.h"
#include "validation/observe/observe.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {
namespace {

// The least that an engine can be: it tells neither contacts nor snapshots, and nothing moves.
class Mute final : public Engine {
 public:
  void load(const Problem&, const Accuracy&) override {}
  double time_step() const override { return 1e-3; }
  std::uint64_t steps_done() const override { return steps_; }
  void advance(std::uint64_t steps) override { steps_ += steps; }
  BodyMotion body(std::size_t) const override { return {Vec3::Zero(), Vec3::Zero()}; }
  Energies energies() const override { return {}; }
  Momenta momenta() const override { return {Vec3::Zero(), Vec3::Zero()}; }
  Settings settings() const override { return {}; }
  Cost cost() const override { return {}; }
  std::uint64_t state_hash() const override { return 0; }

 private:
  std::uint64_t steps_ = 0;
};

Record run_on_mute(const std::function<void(CaseRun&)>& run) {
  EngineKind kind{
      .name = "mute",
      .description = "a test",
      .manifest = {.boxes = true},
      .settings_help = {},
      .make = [](const Settings&) -> std::unique_ptr<Engine> { return std::make_unique<Mute>(); }};
  return run_job({{.name = "a/case", .title = "a test", .run = run}, kind, {}}, 1.0);
}

void expect_not_applicable(const Record& record, const std::string& words) {
  EXPECT_EQ(record.verdict, Verdict::kNotApplicable);
  EXPECT_EQ(record.error, "");
  ASSERT_FALSE(record.notes.empty());
  EXPECT_EQ(record.notes.front(), words);
}

TEST(Engine, ARecordTellsItsConfigurationAndItsProblem) {
  const Record record = run_on_mute([](CaseRun& run) {
    run.simulate(incline_problem({}));
    run.simulate(incline_problem({}));
  });
  EXPECT_EQ(record.configuration, "default");
  EXPECT_TRUE(record.differs.empty());
  EXPECT_EQ(record.simulations, 2u);
  EXPECT_EQ(record.problem, problem_summary(incline_problem({})));
}

TEST(CalledConfiguration, IsTheOneWithMostOfTheSettings) {
  EngineKind kind;
  kind.configurations = [](const std::string&) -> std::vector<Configuration> {
    return {{.settings = {}, .name = "default"},
            {.settings = {{"iterations", "50"}, {"margin", "0"}}, .name = "best"},
            {.settings = {{"iterations", "50"}}, .name = "more"}};
  };
  const auto called = [&](const Settings& settings) {
    const CalledConfiguration found = called_configuration(kind, "a/case", settings);
    return found.name + " " + variant_text(found.differs);
  };
  EXPECT_EQ(called({}), "default default");
  EXPECT_EQ(called({{"iterations", "50"}}), "more default");
  EXPECT_EQ(called({{"iterations", "50"}, {"margin", "0"}, {"dt", "1e-3"}}), "best dt=1e-3");
  EXPECT_EQ(called({{"iterations", "10"}}), "default iterations=10");
}

TEST(CalledConfiguration, OfOurSolverIsNamedByMethodAndRule) {
  const EngineKind kind = find_engine("stiction");
  const auto called = [&](const Settings& settings) {
    const CalledConfiguration found = called_configuration(kind, "slab/rest/drift", settings);
    return found.name + " | " + variant_text(found.differs);
  };
  EXPECT_EQ(called({{"method", "quiet"}}), "quiet | default");
  EXPECT_EQ(called({{"method", "quiet"}, {"rule", "secant"}}), "quiet | rule=secant");
  EXPECT_EQ(called({{"method", "paper"}, {"rule", "secant"}}), "paper, secant | default");
  EXPECT_EQ(called({{"method", "paper"}, {"kappa", "0.7"}}), "paper, fixed point | kappa=0.7");
  EXPECT_EQ(called({{"method", "old"}}), "old | default");
  // On half-spaces alone the rule is all that methods differ by.
  EXPECT_EQ(called({{"rule", "fixed-point"}}), "paper, fixed point | default");
  EXPECT_EQ(called({{"rule", "conjugate-vector"}}), "quiet | default");
  EXPECT_EQ(called({{"dt", "1e-4"}}), "quiet | dt=1e-4");
}

TEST(Engine, WithoutWhatACaseAsksIsNotApplicableInWords) {
  expect_not_applicable(run_on_mute([](CaseRun& run) {
                          const auto simulation = run.simulate(incline_problem({}));
                          simulation->advance(1);
                          run.check({.quantity = "deepest", .tolerance = 1.0}, 0.0);
                          fastest_slip(simulation->engine());
                        }),
                        "the engine does not tell its contacts");
  expect_not_applicable(
      run_on_mute([](CaseRun& run) { run.simulate(incline_problem({}))->engine().save(); }),
      "the engine has no snapshots");
  expect_not_applicable(
      run_on_mute([](CaseRun& run) { run.need(&Manifest::snapshots, "snapshots"); }),
      "the engine has no snapshots");
  InclineSetup point;
  point.shape = PointShape{};
  expect_not_applicable(run_on_mute([&](CaseRun& run) { run.simulate(incline_problem(point)); }),
                        "the engine has no point masses");
}

TEST(Missing, IsWhatAnEngineIsNotToldOf) {
  Problem problem = incline_problem({});
  Manifest manifest;
  manifest.boxes = manifest.moving_obstacles = true;
  ASSERT_EQ(missing(manifest, problem), "");
  problem.obstacles[0].motion.oscillation.amplitude.x() = 0.1;
  problem.obstacles[0].motion.velocity.y() = 0.1;
  problem.pair_friction = {{.friction = 0.5}};
  problem.restitution = 0.5;
  EXPECT_EQ(missing(manifest, problem),
            "steadily moving supports, sines over time, friction of single pairs, restitution");
  manifest = {.boxes = true, .steady_motion = true, .oscillation = true};
  EXPECT_EQ(missing(manifest, problem), "moving obstacles, friction of single pairs, restitution");
}

}  // namespace
}  // namespace stiction
