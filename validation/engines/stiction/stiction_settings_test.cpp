// SPDX-License-Identifier: GPL-3.0-or-later
// What a user may set of this project's solver, and what is refused.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/friction/catalog.h"
#include "solver/testing/test_refusal.h"
#include "validation/engines/stiction/test_engine.h"

namespace stiction {
namespace {

using test::loaded;
using test::slope;
using testing::HasSubstr;

TEST(StictionSettings, ResolvesItsSettings) {
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
TEST(StictionSettings, TakesTellsAndRefusesTheParametersOfEachRule) {
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

TEST(StictionSettings, RefusesUnknownSettingsWhenItIsMade) {
  EXPECT_EQ(
      test::refusal([] {
        find_engine("stiction").make({{"sped", "1"}});
      }),
      "engine 'stiction' has no setting 'sped'; there are: alpha, ball, border, bound, cells, "
      "count-hysteresis, depth, depth-noise, dt, edges, face, gain, hysteresis, integrator, kappa, "
      "key, memory, "
      "method, normals, order, "
      "post-correction, reaction, relaxation, rule, safeguard, settled, slip-tolerance, sweeps, "
      "tie, "
      "weights");
}

TEST(StictionSettings, SaysWhyASettingHasNoEffect) {
  const auto idle = find_engine("stiction").idle;
  const auto sentences = idle({{"method", "old"}, {"gain", "0.6"}, {"memory", "keep"}});
  ASSERT_EQ(sentences.size(), 2u);
  EXPECT_EQ(sentences.at("gain"), "rule 'none' has no parameter 'gain'; it has none");
  EXPECT_EQ(idle({{"gain", "0.6"}}).at("gain"),
            "rule 'conjugate-vector' has no parameter 'gain'; it has relaxation, slip-tolerance");
  EXPECT_TRUE(idle({{"method", "paper"}, {"gain", "0.6"}, {"kappa", "1"}}).empty());
}

TEST(StictionSettings, RefusesWhatIsOutOfRangeWhenItIsMade) {
  const auto refused = [](const Settings& settings) {
    return test::refusal([&] { find_engine("stiction").make(settings); });
  };
  EXPECT_EQ(refused({{"slip-tolerance", "-3"}}),
            "rule 'conjugate-vector': 'slip-tolerance' must be at least 0, not -3");
  EXPECT_EQ(refused({{"tie", "1"}}), "the tie margin must lie in [0, 1), not 1");
  EXPECT_EQ(refused({{"dt", "-1"}}), "the time step must be positive and finite, not -1 s");
}

TEST(StictionSettings, ShortensTheDefaultStepWhereStabilityAsksForIt) {
  InclineSetup stiff = slope(0.3);
  stiff.elasticity.youngs_modulus = 5e7;
  stiff.elasticity.damping_time = 0.0;
  const double dt = loaded(incline_problem(stiff))->time_step();
  EXPECT_LT(dt, 2e-4);
  // A whole number of them makes 10 ms, and one less would be above 80 % of the limit.
  const double count = 1e-2 / dt;
  EXPECT_NEAR(count, std::round(count), 1e-9 * count);
  const auto accepts = [&](double step) {
    return test::refusal([&] {
             loaded(incline_problem(stiff), {{"dt", fmt::format("{}", step)}});
           })
        .empty();
  };
  EXPECT_TRUE(accepts(dt / 0.81)) << "80 % of the limit";
  EXPECT_FALSE(accepts(1e-2 / (count - 1.0) / 0.79)) << "no smaller than need be";
}

// Its elements' limit is what it is checked against, and below 80 % of that of the body it is in.
TEST(StictionSettings, TakesAStepNearerTheLimitOfADampedBodyAlone) {
  InclineSetup damped = slope(0.3);
  damped.elasticity.youngs_modulus = 5e7;
  damped.elasticity.damping_time = 1e-4;
  const Problem problem = incline_problem(damped);
  const double dt = loaded(problem)->time_step();
  EXPECT_NE(test::refusal([&] {
              loaded(problem, {{"dt", fmt::format("{}", dt / 0.81)}});
            }),
            "")
      << "above 80 % of the limit";
}

TEST(StictionSettings, RoundsTheDefaultStepDownWhereBodiesCanTouch) {
  InclineSetup stiff = slope(0.3);
  stiff.elasticity.youngs_modulus = 5e7;
  Problem two = incline_problem(stiff);
  two.bodies.push_back(two.bodies.front());
  two.bodies.back().name = "another";
  two.bodies.back().position += Vec3(0.0, 10.0, 0.0);
  const double dt = loaded(two)->time_step();
  // One of 1, 2, 5 × 10ⁿ.
  const double mantissa = dt / std::pow(10.0, std::floor(std::log10(dt * (1.0 + 1e-9))));
  EXPECT_LT(
      std::min({std::abs(mantissa - 1.0), std::abs(mantissa - 2.0), std::abs(mantissa - 5.0)}),
      1e-9)
      << dt;
}

TEST(StictionSettings, NamesTheLimitAndTheElementOfATooLongStep) {
  const std::string sentence = test::refusal([] {
    loaded(incline_problem(slope(0.3)), {{"dt", "0.01"}});
  });
  EXPECT_THAT(sentence, HasSubstr("the time step 0.01 s is above the stability limit"));
  EXPECT_THAT(sentence, HasSubstr("set by tetrahedron"));
  EXPECT_THAT(sentence, HasSubstr("(body 'box')"));
}

TEST(StictionSettings, RefusesAMassThatIsNotPositive) {
  for (const double mass : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    Problem problem = incline_problem(slope(0.3));
    problem.bodies[0].mass = mass;
    EXPECT_THAT(test::refusal([&] { loaded(problem); }),
                HasSubstr("body 'box': mass must be positive and finite"));
  }
}

}  // namespace
}  // namespace stiction
