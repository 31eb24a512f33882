// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/rule_history.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stiction {
namespace {

RuleHistory history_of(const std::vector<double>& mean_slip) {
  RuleHistory history;
  history.time_step = 0.5;
  for (const double slip : mean_slip)
    history.slips.push_back({.mean = slip, .fastest = 2.0 * slip, .contacts = 4});
  return history;
}

TEST(RuleHistory, CountsStepsUntilTheSlipStaysBelow) {
  const RuleHistory history = history_of({1e-3, 1e-7, 1e-5, 1e-7, 1e-10});
  EXPECT_EQ(history.steps_to(1e-6), 4.0) << "the third step was above again";
  EXPECT_EQ(history.steps_to(1e-9), 5.0);
  EXPECT_TRUE(std::isinf(history.steps_to(1e-11)));
  EXPECT_EQ(history.steps_to(1.0), 1.0);
}

TEST(RuleHistory, CountsForTheFastestContactToo) {
  const RuleHistory history = history_of({1e-3, 0.9e-6, 1e-7, 1e-10});
  EXPECT_EQ(history.steps_to(1e-6), 2.0);
  EXPECT_EQ(history.steps_to(1e-6, &ContactSlips::fastest), 3.0);
}

TEST(RuleHistory, CountsFromTheLastStepAboveASlip) {
  const RuleHistory history = history_of({1e-5, 2e-3, 1e-5, 1e-10});
  EXPECT_EQ(history.steps_from(1e-3, 1e-9, &ContactSlips::mean), 2.0);
  EXPECT_TRUE(std::isnan(history.steps_from(1.0, 1e-9, &ContactSlips::mean))) << "never so fast";
  RuleHistory released = history_of({1e-5, 1e-10});
  released.start.mean = 1e-3;
  EXPECT_EQ(released.steps_from(1e-3, 1e-9, &ContactSlips::mean), 2.0);
  EXPECT_TRUE(std::isinf(history.steps_from(1e-3, 1e-11, &ContactSlips::mean)));
}

TEST(RuleHistory, NeverGetsThereWhenItFailed) {
  RuleHistory history = history_of({1e-10, 1e-10});
  history.failure = "a body moved";
  EXPECT_TRUE(std::isinf(history.steps_to(1e-6)));
}

TEST(RuleHistory, CreepIsOfTheLastTenth) {
  std::vector<double> slips(20, 1.0);
  slips[18] = 2.0;
  slips[19] = 4.0;
  EXPECT_EQ(history_of(slips).creep(), 3.0);
  EXPECT_TRUE(std::isinf(history_of({}).creep()));
}

TEST(RuleHistory, WhatHasTakenOffDoesNotHold) {
  RuleHistory history = history_of({1e-10, 1e-10});
  history.slips.back().contacts = 0;
  EXPECT_TRUE(std::isinf(history.creep()));
}

TEST(RuleHistory, PathIsSlipOverTime) { EXPECT_EQ(history_of({1.0, 2.0, 3.0}).path(), 3.0); }

}  // namespace
}  // namespace stiction
