// SPDX-License-Identifier: BSD-3-Clause
#include "solver/parallel/team_choice.h"

#include <gtest/gtest.h>

namespace stiction {
namespace {

double now = 0.0;  // s
double read_clock() { return now; }

// Steps that take so long alone and by a team, as its choice has them done.
class Steps {
 public:
  explicit Steps(const Team& team) : choice(team, read_clock) {}

  // The share of `count` steps that the team does.
  double by_team(int count, double alone, double together) {
    int done = 0;
    for (int k = 0; k < count; ++k) {
      const bool team = choice.begin_step() != nullptr;
      now += team ? together : alone;
      choice.end_step();
      done += team;
    }
    return static_cast<double>(done) / count;
  }
  // One step that something else holds up.
  void interrupted(double seconds) {
    choice.begin_step();
    now += seconds;
    choice.end_step();
  }

  TeamChoice choice;
};

constexpr int kTrial = TeamChoice::kTrial;

TEST(TeamChoice, LeavesTheStepsToWhoTakesLess) {
  const Team team(1);
  Steps pays(team);
  pays.by_team(TeamChoice::kFirst + kTrial, 10e-6, 6e-6);
  EXPECT_EQ(pays.choice.chosen(), &team);
  Steps costs(team);
  costs.by_team(TeamChoice::kFirst + kTrial, 10e-6, 14e-6);
  EXPECT_EQ(costs.choice.chosen(), nullptr);
  Steps saves_little(team);
  saves_little.by_team(TeamChoice::kFirst + kTrial, 10e-6, 9.8e-6);
  EXPECT_EQ(saves_little.choice.chosen(), nullptr) << "a processor for a fiftieth";
}

TEST(TeamChoice, SoonTriesSeldom) {
  const Team team(1);
  Steps costs(team);
  costs.by_team(20000, 10e-6, 14e-6);
  // Two trials in so many, of which half is done by the team.
  constexpr double kTried = static_cast<double>(kTrial) / (2 * TeamChoice::kLatest);
  EXPECT_LE(costs.by_team(2 * TeamChoice::kLatest, 10e-6, 14e-6), kTried);
  Steps pays(team);
  pays.by_team(20000, 10e-6, 6e-6);
  EXPECT_GE(pays.by_team(2 * TeamChoice::kLatest, 10e-6, 6e-6), 1.0 - kTried);
}

TEST(TeamChoice, FollowsWhatChanges) {
  const Team team(1);
  Steps steps(team);
  steps.by_team(20000, 10e-6, 14e-6);
  ASSERT_EQ(steps.choice.chosen(), nullptr);
  int until_seen = 0;
  for (; steps.choice.chosen() == nullptr; ++until_seen) steps.by_team(1, 100e-6, 60e-6);
  EXPECT_LE(until_seen, TeamChoice::kLatest + 2 * kTrial);
  // After a change it looks again soon.
  steps.by_team(TeamChoice::kSoonest + kTrial, 10e-6, 14e-6);
  EXPECT_EQ(steps.choice.chosen(), nullptr);
}

TEST(TeamChoice, IsNotMadeByATurnThatAnotherProgramHoldsUp) {
  const Team team(1);
  for (int turn = 0; turn < TeamChoice::kTurns; ++turn) {
    for (const bool pays : {false, true}) {
      Steps steps(team);
      const double together = pays ? 6e-6 : 14e-6;
      steps.by_team(TeamChoice::kFirst + turn * TeamChoice::kInARow, 10e-6, together);
      for (int k = 0; k < TeamChoice::kInARow; ++k) steps.interrupted(4e-3);
      steps.by_team(kTrial, 10e-6, together);
      EXPECT_EQ(steps.choice.chosen(), pays ? &team : nullptr) << turn;
    }
  }
}

TEST(TeamChoice, HasNothingOfAStepThatThrew) {
  const Team team(1);
  Steps steps(team);
  steps.by_team(TeamChoice::kFirst + TeamChoice::kUntimed, 10e-6, 6e-6);
  for (int k = 0; k < kTrial; ++k) {
    steps.choice.begin_step();  // and no end
    now += 1.0;
  }
  // The trial has not gone on: what is left of it is half by the team.
  constexpr int kLeft = kTrial - TeamChoice::kUntimed;
  EXPECT_DOUBLE_EQ(steps.by_team(kLeft, 10e-6, 6e-6) * kLeft, 0.5 * kTrial - TeamChoice::kUntimed);
  EXPECT_EQ(steps.choice.chosen(), &team);
}

}  // namespace
}  // namespace stiction
