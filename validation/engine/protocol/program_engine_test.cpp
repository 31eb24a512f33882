// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "reference/process/child.h"
#include "solver/demand.h"
#include "validation/core/case_run.h"
#include "validation/core/runner.h"
#include "validation/engine/protocol/problem_json.h"
#include "validation/engine/protocol/program_kind.h"
#include "validation/engine/protocol/test_program.h"
#include "validation/problems/slopes/incline_problem.h"

namespace stiction {
namespace {

using test::program;
using testing::HasSubstr;

Problem slope() {
  InclineSetup setup;
  setup.tan_slope = 0.6;
  setup.speed = 0.5;
  return incline_problem(setup);
}

// A script that answers `hello`, and then what it is told, a line a request.
std::string rogue(const std::string& after) {
  const std::string file = testing::TempDir() + "/rogue-" +
                           testing::UnitTest::GetInstance()->current_test_info()->name() + ".sh";
  std::ofstream(file)
      << "read -r line\n"
         "case $line in *hello*)\n"
         "echo '{\"protocol\":1,\"name\":\"rogue\",\"version\":\"\",\"description\":\"\",\"can\":"
         "[\"boxes\"]}'; exit ;; esac\n"
      << after;
  return "sh '" + file + "'";
}

const std::string kLoaded = "echo '{\"time_step\":0.01}'\nread -r line\n";
const std::string kBodies =
    "echo '{\"bodies\":{\"position\":[0,0,0],\"velocity\":[0,0,0],\"rotation\":[1,0,0,0],"
    "\"angular_velocity\":[0,0,0]}}'\nread -r line\n";

std::string complaint(const std::string& command) {
  try {
    const auto engine = find_engine(command).make({});
    engine->load(slope(), {});
    engine->advance(10);
    engine->body(0);
  } catch (const std::exception& what) {
    return what.what();
  }
  return "no complaint";
}

TEST(ProgramEngine, AnswersThroughPipesAsDirectlyToTheLastBit) {
  const EngineKind hosted = find_engine(program("hosted_engine"));
  const EngineKind direct = find_engine("stiction");
  const auto far = hosted.make({{"method", "quiet"}}), near = direct.make({{"method", "quiet"}});
  for (const auto& engine : {far.get(), near.get()}) {
    engine->load(slope(), {.fineness = 3});
    engine->advance(500);
  }
  EXPECT_EQ(far->time_step(), near->time_step());
  EXPECT_EQ(far->body(0).position, near->body(0).position);
  EXPECT_EQ(far->body(0).velocity, near->body(0).velocity);
  EXPECT_EQ(far->energies().kinetic, near->energies().kinetic);
  EXPECT_EQ(far->energies().elastic, near->energies().elastic);
  EXPECT_EQ(far->momenta().angular, near->momenta().angular);
  EXPECT_EQ(far->vertices(0), near->vertices(0));
  EXPECT_EQ(far->surface(0), near->surface(0));
  ASSERT_EQ(far->contacts().size(), near->contacts().size());
  ASSERT_GT(near->contacts().size(), 0u);
  EXPECT_EQ(far->contacts()[0].friction_force, near->contacts()[0].friction_force);
  EXPECT_EQ(far->settings().at("rule"), near->settings().at("rule"));
}

// Sines, steady motion and the friction of a pair cross the protocol whole.
TEST(ProgramEngine, IsToldAllThatChangesOverTimeAndTheFrictionOfPairs) {
  const Oscillation sine{Vec3(0.0, 0.01, 0.0), 3.0, 0.25, 0.01, 0.03};
  Problem problem = slope();
  problem.gravity.oscillation = {Vec3(0.5, 0.0, 0.25), 2.0, 0.0, 0.0, 0.0};
  problem.obstacles[0].motion.velocity = Vec3(0.1, 0.05, 0.0);
  problem.obstacles[0].motion.oscillation = sine;
  problem.loads = {{.body = 0, .force = {{0.0}, {Vec3(0.1, 0.0, 0.0)}, sine}}};
  problem.pair_friction = {{.body = 0, .other = 0, .friction = 0.3}};
  const auto position = [&](const char* name, const Problem& given) {
    const auto engine = find_engine(name).make({{"method", "quiet"}});
    engine->load(given, {.fineness = 2});
    engine->advance(200);
    return engine->body(0).position;
  };
  const Vec3 near = position("stiction", problem);
  EXPECT_EQ(position(program("hosted_engine").c_str(), problem), near);
  std::vector<Problem> less(5, problem);
  less[0].gravity.oscillation = {};
  less[1].obstacles[0].motion.velocity.setZero();
  less[2].obstacles[0].motion.oscillation = {};
  less[3].loads[0].force.oscillation = {};
  less[4].pair_friction.clear();
  for (const Problem& one : less) EXPECT_NE(position("stiction", one), near);
}

TEST(ProgramEngine, GoesOnFromASavedState) {
  const auto engine = find_engine(program("hosted_engine")).make({});
  engine->load(slope(), {});
  engine->advance(100);
  const Snapshot saved = engine->save();
  engine->advance(100);
  const std::uint64_t hash = engine->state_hash();
  engine->restore(saved);
  EXPECT_EQ(engine->steps_done(), 100u);
  engine->advance(100);
  EXPECT_EQ(engine->state_hash(), hash);
}

TEST(ProgramEngine, CountsTheCpuTimeOfItsStepsAlone) {
  const auto engine = find_engine(program("hosted_engine")).make({});
  engine->load(slope(), {});
  EXPECT_EQ(engine->cost().cpu_seconds, 0.0);
  engine->advance(5000);
  const Cost cost = engine->cost();
  EXPECT_EQ(cost.steps, 5000u);
  EXPECT_GT(cost.told_cpu_seconds, 0.0);
  // What the suite measures has the message beside the steps, under a millisecond of it.
  EXPECT_GE(cost.cpu_seconds, cost.told_cpu_seconds);
  EXPECT_LT(cost.cpu_seconds, cost.told_cpu_seconds + 5e-3);
}

TEST(ProgramEngine, ReckonsEnergiesAndMomentaOfRigidBodies) {
  const auto engine = find_engine(program("minimal_engine")).make({});
  Problem problem = slope();
  problem.obstacles.clear();
  engine->load(problem, {});
  engine->advance(100);
  const double speed = engine->body(0).velocity.norm();
  EXPECT_NEAR(engine->energies().kinetic, 0.5 * speed * speed, 1e-12);
  EXPECT_NEAR(engine->momenta().linear.norm(), speed, 1e-12);
  EXPECT_EQ(engine->surface(0).cols(), 12);
  EXPECT_THROW(engine->contacts(), NotApplicable);
  EXPECT_THROW(engine->save(), NotApplicable);
}

TEST(ProgramEngine, SaysInOneSentenceWhatAProgramDidInsteadOfAnAnswer) {
  EXPECT_THAT(complaint(rogue("kill -SEGV $$")),
              HasSubstr("asked to load, was ended by signal 11 (Segmentation fault)"));
  EXPECT_THAT(complaint(rogue("echo 'no memory left' >&2; exit 5")),
              HasSubstr("asked to load, ended with exit code 5; its last words: 'no memory left'"));
  EXPECT_THAT(complaint(rogue("echo rubbish")),
              HasSubstr("answered what is no JSON object: 'rubbish'"));
  EXPECT_THAT(complaint(rogue("echo '[1, 2]'")), HasSubstr("no JSON object"));
  EXPECT_THAT(complaint(rogue("echo '{}'")), HasSubstr("time_step: the required field is missing"));
  EXPECT_THAT(complaint(rogue("echo '{\"time_step\":-1}'")), HasSubstr("must be above 0"));
  EXPECT_THAT(complaint(rogue("echo '{\"error\":\"no such box\"}'")),
              HasSubstr("says: no such box"));
  EXPECT_THAT(complaint(rogue("echo '{\"lacks\":\"boxes so small\"}'")), "boxes so small");
}

TEST(ProgramEngine, TakesNoNumberThatIsNoneAndNoClockThatStands) {
  const std::string nan =
      "echo '{\"bodies\":{\"position\":[0,null,0],\"velocity\":[0,0,0],\"rotation\":[1,0,0,0],"
      "\"angular_velocity\":[0,0,0]}}'";
  EXPECT_THAT(complaint(rogue(kLoaded + nan)), HasSubstr("'position' has null where a number"));
  const std::string two =
      "echo '{\"bodies\":{\"position\":[0,0],\"velocity\":[0,0,0],\"rotation\":"
      "[1,0,0,0],\"angular_velocity\":[0,0,0]}}'";
  EXPECT_THAT(complaint(rogue(kLoaded + two)), HasSubstr("has 2 numbers where 3 belong"));
  EXPECT_THAT(complaint(rogue(kLoaded + kBodies + "echo '{\"steps\":10,\"time\":0}'")),
              HasSubstr("its clock stands at 0 s after 10 steps of 0.01 s: did time advance?"));
  EXPECT_THAT(complaint(rogue(kLoaded + kBodies + "echo '{\"steps\":9,\"time\":0.09}'")),
              HasSubstr("has done 9 steps where 10 were asked for"));
}

// A hang costs its time limit and that case alone.
TEST(ProgramEngine, IsGivenUpAfterItsTime) {
  set_program_limits({.reply_seconds = 0.3});
  const std::string said = complaint(rogue(kLoaded + kBodies + "sleep 600"));
  set_program_limits({});
  EXPECT_THAT(said, HasSubstr("asked to advance, gave no answer within 0.3 s"));
}

TEST(ProgramEngine, ACrashIsTheErrorOfOneCase) {
  const Case one{.name = "a/case", .run = [](CaseRun& run) { run.simulate(slope())->advance(10); }};
  const Record record =
      run_job({one, find_engine(rogue(kLoaded + kBodies + "kill -9 $$")), {}}, 1.0);
  EXPECT_EQ(record.verdict, Verdict::kError);
  EXPECT_THAT(record.error, HasSubstr("was ended by signal 9 (Killed)"));
}

TEST(ProgramEngine, RefusesProblemsThatCannotBe) {
  const auto refusal = [](const std::function<void(Problem&)>& spoil) -> std::string {
    Problem problem = slope();
    spoil(problem);
    try {
      find_engine(program("minimal_engine")).make({})->load(problem, {});
    } catch (const InputError& what) {
      return what.what();
    }
    return "taken";
  };
  EXPECT_EQ(refusal([](Problem&) {}), "taken");
  EXPECT_THAT(refusal([](Problem& p) { p.bodies[0].mass = -1.0; }),
              HasSubstr("mass must be above 0"));
  EXPECT_THAT(refusal([](Problem& p) { p.bodies[0].position[1] = std::nan(""); }),
              HasSubstr("position is not a finite number"));
  EXPECT_THAT(refusal([](Problem& p) { p.obstacles[0].normal *= 2.0; }), HasSubstr("length 1"));
  EXPECT_THAT(refusal([](Problem& p) { p.obstacles[0].friction = -0.1; }), HasSubstr("below 0"));
  EXPECT_THAT(refusal([](Problem& p) { p.loads.push_back({.body = 7}); }), HasSubstr("not there"));
  EXPECT_THAT(refusal([](Problem& p) { p.bodies.clear(); }), HasSubstr("no bodies"));
}

TEST(ProblemSummary, IsTheProblemWithABoxInsteadOfAMesh) {
  Problem problem = incline_problem({});
  EXPECT_EQ(nlohmann::json::parse(problem_summary(problem)), problem_json(problem));
  MeshShape shape;
  shape.mesh.vertices = Eigen::Matrix3Xd::Random(3, 5);
  shape.mesh.vertices.col(2) << -3.0, 2.0, 7.0;
  shape.mesh.tetrahedra.resize(4, 2);
  shape.mesh.tetrahedra << 0, 1, 1, 2, 2, 3, 3, 4;
  problem.bodies[0].shape = shape;
  const nlohmann::json mesh =
      nlohmann::json::parse(problem_summary(problem))["bodies"][0]["shape"]["mesh"];
  EXPECT_EQ(mesh["vertices"], 5);
  EXPECT_EQ(mesh["tetrahedra"], 2);
  EXPECT_EQ(mesh["low"][0], -3.0);
  EXPECT_EQ(mesh["high"][2], 7.0);
}

TEST(ProgramKind, SaysWhatIsWrongWithAManifest) {
  const auto refusal = [](const std::string& words) -> std::string {
    try {
      find_engine(words);
    } catch (const InputError& what) {
      return what.what();
    }
    return "taken";
  };
  EXPECT_THAT(refusal("no_such_engine"),
              HasSubstr("unknown engine 'no_such_engine'; there are: plain"));
  EXPECT_THAT(refusal("./no/such/engine"), HasSubstr("cannot be started"));
  EXPECT_THAT(refusal("sh 'unfinished"), HasSubstr("a quote does not end"));
  EXPECT_THAT(refusal("sh -c 'read -r line; echo \"{}\"'"),
              HasSubstr("protocol: the required field is missing"));
  const std::string hello = "sh -c 'read -r line; echo \"{\\\"protocol\\\":2}\"'";
  EXPECT_THAT(refusal(hello), HasSubstr("speaks version 1"));
}

// An engine that took the name of another would take its row.
TEST(ProgramKind, RefusesANameThatIsTakenOrNoName) {
  const auto refusal = [](const std::string& name) -> std::string {
    const std::string file = testing::TempDir() + "/impostor.sh";
    std::ofstream(file) << "read -r line\necho '{\"protocol\":1,\"name\":\"" << name
                        << "\",\"version\":\"\",\"description\":\"\",\"can\":[]}'\n";
    try {
      find_engine("sh '" + file + "'");
    } catch (const InputError& what) {
      return what.what();
    }
    return "taken";
  };
  EXPECT_EQ(refusal("an engine 2.1"), "taken");
  EXPECT_THAT(refusal("stiction"),
              HasSubstr("calls itself 'stiction', which is an engine of this"));
  for (const char* const name : {"", "a|b", "<script>"}) {
    EXPECT_THAT(refusal(name), HasSubstr("must be 1 to 40 letters")) << name;
  }
}

TEST(CommandWords, SplitAtSpacesButNotWithinQuotes) {
  using testing::ElementsAre;
  EXPECT_THAT(command_words("python3 my_engine.py  --fast"),
              ElementsAre("python3", "my_engine.py", "--fast"));
  EXPECT_THAT(command_words("python3 'my engine.py' \"\" a\"b c\"d"),
              ElementsAre("python3", "my engine.py", "", "ab cd"));
  EXPECT_THAT(command_words(""), ElementsAre());
}

}  // namespace
}  // namespace stiction
