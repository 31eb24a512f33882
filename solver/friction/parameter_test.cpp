// SPDX-License-Identifier: BSD-3-Clause
// What a rule declares, shown with a rule that no other file knows, and held against every rule of
// the catalog.
#include "solver/friction/parameter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "solver/friction/catalog.h"
#include "solver/friction/with_rule.h"

namespace stiction {
namespace {

// A bristle that gives way: with a parameter of its own and a shared one.
struct Bristle {
  static constexpr RuleParameter kStiffness{.name = "bristle",
                                            .help = "stiffness of a bristle",
                                            .unit = "N/m",
                                            .initial = 1e4,
                                            .low = 0.0,
                                            .high = 1e6,
                                            .open = true};
  static constexpr std::array kParameters{kStiffness, parameter::kMemory};

  explicit Bristle(const RuleSettings& given)
      : stiffness(value_of(kStiffness, given)), keeps(is_on(parameter::kMemory, given)) {}
  double stiffness;
  bool keeps;
};

struct Bare {};

std::string refusal(const RuleSettings& given) {
  return refusal_of("bristle-rule", parameters_of<Bristle>(), given);
}

TEST(RuleParameters, AreTheDefaultsUnlessGiven) {
  EXPECT_EQ(Bristle({}).stiffness, 1e4);
  EXPECT_FALSE(Bristle({}).keeps);
  const Bristle given({{"bristle", 5.0}, {"memory", 1.0}});
  EXPECT_EQ(given.stiffness, 5.0);
  EXPECT_TRUE(given.keeps);
}

TEST(RuleParameters, MayBeNone) {
  EXPECT_TRUE(parameters_of<Bare>().empty());
  EXPECT_EQ(refusal_of("bare", parameters_of<Bare>(), {}), "");
}

TEST(RuleParameters, AreRefusedOutOfTheirRangeAndWithoutTheirRule) {
  EXPECT_EQ(refusal({}), "");
  EXPECT_EQ(refusal({{"bristle", 1e5}, {"memory", 1.0}}), "");
  EXPECT_EQ(refusal({{"bristle", 0.0}}),
            "rule 'bristle-rule': 'bristle' must be between 0 and 1e+06, not 0");
  EXPECT_EQ(refusal({{"bristle", std::nan("")}}),
            "rule 'bristle-rule': 'bristle' must be a finite number, not nan");
  EXPECT_EQ(refusal({{"gain", 0.7}}),
            "rule 'bristle-rule' has no parameter 'gain'; it has bristle, memory");
}

TEST(RuleParameters, SayTheirRange) {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  const auto words = [](double low, double high, bool open) {
    return range_words({.name = "", .help = "", .low = low, .high = high, .open = open});
  };
  EXPECT_EQ(words(0.0, kAny, false), "at least 0");
  EXPECT_EQ(words(0.0, kAny, true), "above 0");
  EXPECT_EQ(words(-kAny, 3.0, false), "at most 3");
  EXPECT_EQ(words(-kAny, 3.0, true), "below 3");
  EXPECT_EQ(words(-1.0, 3.0, false), "from -1 to 3");
  EXPECT_EQ(words(-1.0, 3.0, true), "between -1 and 3");
  EXPECT_EQ(words(-kAny, kAny, false), "any number");
  EXPECT_EQ(range_words(parameter::kMemory), "reset or keep");
}

TEST(RuleParameters, OfEachRuleOfTheCatalogAreSound) {
  int declared = 0;
  for (const std::string& rule : friction_rule_names()) {
    for (const RuleParameter& one : friction_rule_parameters(rule)) {
      SCOPED_TRACE(rule + ", " + one.name);
      ++declared;
      EXPECT_EQ(refusal_of(one, one.initial), "") << "the default is in the range";
      EXPECT_EQ(one.off == nullptr, one.on == nullptr);
      EXPECT_STRNE(one.help, "");
      int same = 0;
      bool replaced = one.replaces == nullptr;
      for (const RuleParameter& other : friction_rule_parameters(rule)) {
        if (std::string(other.name) == one.name) ++same;
        if (one.replaces && std::string(other.name) == one.replaces) replaced = true;
      }
      EXPECT_EQ(same, 1) << "a name is there once";
      EXPECT_TRUE(replaced) << "what it replaces is one of the rule's";
    }
  }
  EXPECT_GT(declared, 0);
}

}  // namespace
}  // namespace stiction
