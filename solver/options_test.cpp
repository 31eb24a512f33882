// SPDX-License-Identifier: BSD-3-Clause
#include "solver/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/friction/catalog.h"
#include "solver/friction/with_rule.h"
#include "solver/testing/test_scenes.h"

namespace stiction {
namespace {

using testing::HasSubstr;

Scene elastic_scene() {
  return build_scene(test::one_body(test::elastic_body(test::corner_tetrahedron(0.1))));
}

std::string refusal(const Options& options) {
  const Scene scene = elastic_scene();
  return test::refusal([&] { check_options(options, scene); });
}

TEST(CheckOptions, AcceptsTheDefaults) { EXPECT_EQ(refusal({}), ""); }

TEST(CheckOptions, AcceptsTheStabilityLimitItselfAndNothingAbove) {
  const double limit = elastic_scene().stable_time_step;
  EXPECT_EQ(refusal({.time_step = limit}), "");
  EXPECT_NE(refusal({.time_step = limit * (1.0 + test::kEpsilon)}), "");
}

TEST(CheckOptions, NamesTheLimitAndTheElementOfATooLongStep) {
  Scene scene = elastic_scene();
  scene.stable_time_step = 0.00123456789;
  scene.stiffest_element = 17;
  EXPECT_EQ(test::refusal([&] { check_options({.time_step = 0.01}, scene); }),
            "the time step 0.01 s is above the stability limit 0.00123457 s, set by tetrahedron 17 "
            "(body 'cube')");
}

TEST(CheckOptions, RefusesAStepThatIsNotPositiveAndFinite) {
  EXPECT_EQ(refusal({.time_step = 0.0}), "the time step must be positive and finite, not 0 s");
  EXPECT_EQ(refusal({.time_step = -1e-4}),
            "the time step must be positive and finite, not -0.0001 s");
  EXPECT_EQ(refusal({.time_step = test::kNaN}),
            "the time step must be positive and finite, not nan s");
  EXPECT_EQ(refusal({.time_step = test::kInfinity}),
            "the time step must be positive and finite, not inf s");
}

TEST(CheckOptions, ListsTheRulesWhenOneIsUnknown) {
  const std::string sentence = refusal({.rule = "magic"});
  EXPECT_THAT(sentence, HasSubstr("unknown friction rule 'magic'"));
  EXPECT_THAT(sentence, HasSubstr("none"));
  EXPECT_THAT(sentence, HasSubstr("fixed-point"));
}

TEST(CheckOptions, RefusesParametersThatTheRuleCannotHave) {
  EXPECT_EQ(refusal({.rule = "secant", .friction = {{"gain", test::kNaN}}}),
            "rule 'secant': 'gain' must be a finite number, not nan");
  EXPECT_EQ(refusal({.rule = "fixed-point", .friction = {{"alpha", test::kInfinity}}}),
            "rule 'fixed-point': 'alpha' must be a finite number, not inf");
  EXPECT_EQ(refusal({.friction = {{"slip-tolerance", -3.0}}}),
            "rule 'conjugate-vector': 'slip-tolerance' must be at least 0, not -3");
  EXPECT_EQ(refusal({.rule = "stored-vector", .friction = {{"relaxation", 2.0}}}),
            "rule 'stored-vector': 'relaxation' must be between 0 and 2, not 2");
  EXPECT_EQ(refusal({.rule = "secant", .friction = {{"memory", 0.5}}}),
            "rule 'secant': 'memory' must be reset or keep, not 0.5");
  EXPECT_EQ(refusal({.rule = "none", .friction = {{"gain", 0.7}}}),
            "rule 'none' has no parameter 'gain'; it has none");
  EXPECT_EQ(refusal({.rule = "bias-vector", .friction = {{"relaxation", 1.0}}}),
            "rule 'bias-vector' has no parameter 'relaxation'; it has gain, memory");
}

TEST(CheckOptions, NeedsNoSceneForWhatIsWrongInAny) {
  EXPECT_EQ(test::refusal([] { check_options({.time_step = 1e3}); }), "");
  EXPECT_EQ(test::refusal([] { check_options({.pairs = {.harmonic_gain = 2.0}}); }),
            refusal({.pairs = {.harmonic_gain = 2.0}}));
}

TEST(FrictionRuleCatalog, CallsTheRuleOfThatNameAndNoOther) {
  int values = -1;
  const auto remember = [&](const auto& rule) { values = rule.kValues; };
  EXPECT_TRUE(with_friction_rule("none", {}, remember));
  EXPECT_EQ(values, 0);
  EXPECT_TRUE(with_friction_rule("fixed-point", {}, remember));
  EXPECT_EQ(values, 1);
  values = -1;
  EXPECT_FALSE(with_friction_rule("fixed_point", {}, remember));
  EXPECT_EQ(values, -1);
}

TEST(FrictionRuleCatalog, ListsEveryRuleItKnows) {
  std::string rest = friction_rule_list() + ", ";
  while (!rest.empty()) {
    const std::size_t end = rest.find(", ");
    EXPECT_TRUE(is_friction_rule(rest.substr(0, end))) << rest.substr(0, end);
    rest.erase(0, end + 2);
  }
}

}  // namespace
}  // namespace stiction
