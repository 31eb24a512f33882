// SPDX-License-Identifier: GPL-3.0-or-later
// Answers of an engine's program, a line each: hello, load, and whatever it is then asked. The suite
// sees a value or one sentence.
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>

#include "fuzz/property.h"
#include "reference/process/child.h"
#include "solver/demand.h"
#include "validation/engine/protocol/program_kind.h"

using namespace stiction;

namespace {

Problem two_boxes() {
  Problem problem;
  problem.name = "two boxes";
  for (const char* const name : {"a", "b"}) {
    ProblemBody body;
    body.name = name;
    body.shape = BoxShape{};
    problem.bodies.push_back(body);
  }
  problem.obstacles.push_back({});
  return problem;
}

bool is_finite(const BodyMotion& motion) {
  return motion.position.allFinite() && motion.velocity.allFinite() &&
         motion.rotation.coeffs().allFinite() && motion.angular_velocity.allFinite();
}

void look(const Engine& engine) {
  for (std::size_t b = 0; b < 2; ++b) {
    fuzz::hold(is_finite(engine.body(b)), "a body's motion consists of numbers");
    const Eigen::Matrix3Xi triangles = engine.surface(b);
    const Eigen::Matrix3Xd vertices = engine.vertices(b);
    fuzz::hold(vertices.allFinite(), "a body's vertices consist of numbers");
    fuzz::hold(triangles.size() == 0 ||
                   (triangles.minCoeff() >= 0 && triangles.maxCoeff() < vertices.cols()),
               "a body's triangles have vertices");
  }
  const Energies energies = engine.energies();
  fuzz::hold(std::isfinite(energies.kinetic + energies.gravity + energies.elastic),
             "energies are numbers");
  fuzz::hold(engine.momenta().angular.allFinite(), "momenta are numbers");
  for (const ContactSample& contact : engine.contacts()) {
    fuzz::hold(contact.body < 2 && contact.obstacle < 2 && contact.friction_force.allFinite(),
               "a contact is of bodies that are there");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream lines(std::string(data, data + size));
  const Answers answers = [&](const std::string&) {
    std::string line;
    if (!std::getline(lines, line)) throw reference::ChildError("has ended");
    return line;
  };
  const auto kind =
      fuzz::value_or_sentence<InputError>([&] { return program_kind({"./engine"}, answers); });
  if (!kind) return 0;
  fuzz::value_or_sentence<std::runtime_error>([&] {
    const auto engine = kind->make({});
    engine->load(two_boxes(), {});
    look(*engine);
    const Snapshot start = kind->manifest.snapshots ? engine->save() : nullptr;
    engine->advance(2);
    look(*engine);
    if (start) engine->restore(start);
    return engine->state_hash();
  });
  return 0;
}
