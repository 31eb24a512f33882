// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engine/conformance/conformance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <string>

#include "reference/process/child.h"
#include "solver/demand.h"

namespace stiction {
namespace {

using testing::HasSubstr;

EngineKind hosted() {
  return find_engine((reference::folder_of_this_program() / "hosted_engine").string());
}

std::string failures(const std::vector<Finding>& found) {
  std::string text;
  for (const Finding& one : found) {
    if (one.conformity == Conformity::kFails) text += one.name + ": " + one.sentence + "\n";
  }
  return text;
}

TEST(Conformance, HoldsForEachEngineOfTheBuild) {
  for (const EngineKind& kind : engine_catalog()) {
    EXPECT_EQ(failures(check_conformance(kind, {})), "") << kind.name;
  }
}

TEST(Conformance, HoldsForAnEngineWithoutAFaultAndTriesAllOfIt) {
  for (const Finding& one : check_conformance(hosted(), {})) {
    // Bodies of our solver rebound by their elasticity.
    const bool lacks = one.name == std::string("restitution");
    EXPECT_EQ(one.conformity, lacks ? Conformity::kNotApplicable : Conformity::kHolds)
        << one.name << ": " << one.sentence;
  }
}

// Verlet's steps, of an engine that says that it takes those of symplectic Euler.
TEST(Conformance, HoldsAnEngineToTheSchemeThatItClaims) {
  EXPECT_THAT(failures(check_conformance(hosted(), {{"integrator", "verlet"}})),
              HasSubstr("it says that it steps by symplectic Euler, but falls"));
}

struct Fault {
  const char* name;
  const char* words;  // that name it
};

class PlantedFault : public testing::TestWithParam<Fault> {};

TEST_P(PlantedFault, IsFoundAndNamed) {
  const std::string found = failures(check_conformance(hosted(), {{"fault", GetParam().name}}));
  EXPECT_THAT(found, HasSubstr(GetParam().words));
  EXPECT_THROW(demand_conformance(hosted(), {{"fault", GetParam().name}}), InputError);
}

INSTANTIATE_TEST_SUITE_P(
    OfAnAdapter, PlantedFault,
    testing::Values(
        Fault{"sign", "not below 0"}, Fault{"degrees", "are these degrees, where radians belong?"},
        Fault{"gravity-twice", "is gravity applied twice?"},
        Fault{"swapped", "bodies must keep the problem's order"},
        Fault{"clock", "did time advance?"}, Fault{"forget", "has forgotten its velocity"},
        Fault{"friction", "1.02 times as much at any μ: is it multiplied?"},
        Fault{"half-step", "is each step half as long as the time step that is told"},
        Fault{"nan", "has null where a number belongs"}, Fault{"exit", "ended with exit code 0"},
        Fault{"finer", "divide the time step by `finer`"},
        Fault{"stands", "are positions and velocities those of the same body"}),
    [](const auto& fault) {
      std::string name;
      for (const char sign : std::string(fault.param.name)) {
        if (std::isalnum(static_cast<unsigned char>(sign))) name += sign;
      }
      return name;
    });

}  // namespace
}  // namespace stiction
