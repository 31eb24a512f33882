// SPDX-License-Identifier: BSD-3-Clause
#include "solver/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/friction/catalog.h"
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

TEST(CheckOptions, RefusesGainsThatAreNotNumbers) {
  EXPECT_EQ(refusal({.friction = {.gain = test::kNaN}}), "friction gains must be finite numbers");
  EXPECT_EQ(refusal({.friction = {.raw_alpha = test::kInfinity}}),
            "friction gains must be finite numbers");
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
