// SPDX-License-Identifier: GPL-3.0-or-later
// The schema, the suite and the kits of both languages say the same.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>
#include <vector>

#include "reference/process/child.h"
#include "reference/process/conversation.h"
#include "validation/engine/protocol/problem_json.h"
#include "validation/engine/protocol/test_program.h"

namespace stiction {
namespace {

using nlohmann::json;
using test::program;

const std::filesystem::path kFolder = std::filesystem::path(__FILE__).parent_path();

// What is wrong with a message that should be what a definition says; empty: nothing.
std::string misfit(const json& message, const std::string& definition) {
  std::ifstream stream(kFolder / "protocol.schema.json");
  json document = json::parse(stream);
  document.erase("anyOf");
  document["allOf"] = json::array({{{"$ref", "#/definitions/" + definition}}});
  valijson::Schema schema;
  valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(document),
                                          schema);
  valijson::ValidationResults results;
  valijson::Validator(valijson::Validator::kStrongTypes)
      .validate(schema, valijson::adapters::NlohmannJsonAdapter(message), &results);
  valijson::ValidationResults::Error error;
  std::string text;
  while (results.popError(error)) text += error.description + "; ";
  return text;
}

// A problem with everything in it.
Problem full_problem() {
  Problem problem;
  problem.name = "everything";
  ProblemBody box, ball, mesh;
  box.position = Vec3(0.0, 0.0, 3.0);
  box.shape = BoxShape{};
  ball.position = Vec3(3.0, 0.0, 3.0);
  ball.shape = BallShape{0.1};
  mesh.position = Vec3(0.0, 5.0, 3.0);
  MeshShape shape;
  shape.convex = true;
  shape.mesh.vertices = Eigen::Matrix3Xd::Zero(3, 4);
  shape.mesh.vertices.rightCols(3).setIdentity();
  shape.mesh.tetrahedra = Eigen::Vector4i(0, 1, 2, 3);
  mesh.shape = shape;
  box.held = HeldPart{Vec3(0.0, 0.0, -0.4)};
  box.motion = {{0.0, 1.0}, {Vec3::Zero(), Vec3::UnitX()}};
  problem.bodies = {box, ball, mesh};
  problem.obstacles = {{"ground", Vec3::Zero(), Vec3::UnitZ(), 0.5, {{0.0}, {Vec3::Zero()}}}};
  problem.gravity = {{0.0, 1.0}, {Vec3::Zero(), Vec3(0.0, 0.0, -9.81)}};
  problem.drag = {.rate = 1.0, .full_until = 0.1, .ends = 0.2};
  problem.loads = {
      {.body = 1, .force = {{0.0}, {Vec3::UnitX()}}, .couple = {{0.0}, {Vec3::UnitZ()}}}};
  problem.springs = {{.body = 1, .stiffness = 10.0}};
  return problem;
}

json load_request(const Problem& problem) {
  return {{"do", "load"},
          {"problem", problem_json(problem)},
          {"accuracy", accuracy_json({.fineness = 2})},
          {"settings", json::object()}};
}

void talk(const std::vector<std::string>& words, const Problem& problem,
          const std::vector<std::string>& observed, bool saves) {
  // No limit: built with the address sanitizer an engine maps terabytes.
  reference::Conversation engine(words, {.memory_bytes = 0});
  const auto ask = [&](const json& request) {
    const auto verb = request.at("do").get<std::string>();
    EXPECT_EQ(misfit(request, "request"), "") << request;
    const json reply = json::parse(engine.ask(request.dump()));
    EXPECT_EQ(misfit(reply, "reply_to_" + verb), "") << reply;
    return reply;
  };
  ask({{"do", "hello"}, {"protocol", 1}});
  ask(load_request(problem));
  ask({{"do", "advance"}, {"steps", 3}});
  const json seen = ask({{"do", "observe"}, {"what", observed}});
  EXPECT_EQ(seen.size(), observed.size());
  if (saves) ask({{"do", "restore"}, {"state", ask({{"do", "save"}}).at("state")}});
  const json refused = json::parse(engine.ask(json({{"do", "dance"}}).dump()));
  EXPECT_EQ(misfit(refused, "refusal"), "") << refused;
  ask({{"do", "quit"}});
}

Problem slide() {
  Problem problem = full_problem();
  problem.bodies.resize(1);
  problem.bodies[0].held.reset();
  problem.bodies[0].motion = {};
  problem.loads.clear();
  problem.springs.clear();
  return problem;
}

TEST(ProtocolSchema, HoldsForAllThatTheSuiteAndAnEngineOfTheCKitSay) {
  talk({program("hosted_engine")}, full_problem(),
       {"bodies", "contacts", "energies", "momenta", "surface", "vertices"}, true);
}

TEST(ProtocolSchema, HoldsForTheMinimalEnginesOfBothLanguages) {
  talk({program("minimal_engine")}, slide(), {"bodies"}, false);
  const auto python = kFolder.parent_path() / "kit/examples/minimal_engine.py";
  talk({"python3", python.string()}, slide(), {"bodies"}, false);
}

TEST(ProtocolSchema, TellsAMisfit) {
  EXPECT_NE(misfit({{"do", "hello"}}, "request"), "");
  json request = load_request(slide());
  request["problem"]["bodies"][0]["mass"] = -1.0;
  EXPECT_NE(misfit(request, "request"), "");
  EXPECT_NE(misfit({{"time_step", 0.0}}, "reply_to_load"), "");
}

}  // namespace
}  // namespace stiction
