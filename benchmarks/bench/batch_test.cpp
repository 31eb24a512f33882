// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/bench/batch.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "benchmarks/bench/allocations.h"
#include "benchmarks/bench/cost_model.h"
#include "benchmarks/bench/measure.h"
#include "solver/demand.h"
#include "solver/step.h"

namespace stiction::bench {
namespace {

constexpr int kContacts = 100;

Workload settled(const std::string& name, int contacts = kContacts) {
  for (const WorkloadFamily& family : family_catalog()) {
    if (family.name == name) return settle(family, contacts);
  }
  throw InputError("no family " + name);
}

class EveryFamily : public testing::TestWithParam<std::string> {};

std::vector<std::string> family_names() {
  std::vector<std::string> names;
  for (const WorkloadFamily& family : family_catalog()) names.push_back(family.name);
  return names;
}

TEST_P(EveryFamily, ComesToRestWithAboutTheContactsAskedFor) {
  const Workload work = settled(GetParam());
  for (const Judgement& check : work.checks) {
    EXPECT_EQ(check.verdict, Verdict::kPass) << check.claim.quantity << " " << check.value;
  }
  // The formulas for sizes are for large scenes; a small one has more border.
  EXPECT_GT(work.contacts(), kContacts / 2u);
  EXPECT_LT(work.contacts(), kContacts * 2u);
}

TEST_P(EveryFamily, StaysAtRest) {
  Workload work = settled(GetParam());
  go_on(work, 100);
  for (const Judgement& check : work.checks) {
    EXPECT_EQ(check.verdict, Verdict::kPass) << check.claim.quantity << " " << check.value;
  }
}

TEST(Workload, IsAsFarFromRestAsInTheWorstOfItsLastSteps) {
  Workload shaken = settled("pile");
  for (Velocity& velocity : shaken.state.velocity) velocity.v.z() -= 1e-3;
  Workload at_once = shaken, one_by_one = shaken;
  go_on(at_once, 45);
  go_on(one_by_one, 25);
  double worst = 0.0, last = 0.0;
  for (int k = 0; k < 20; ++k) {
    go_on(one_by_one, 1);
    last = one_by_one.error();
    worst = std::max(worst, last);
  }
  EXPECT_EQ(at_once.error(), worst);
  EXPECT_LT(last, worst);
}

// A drag that ends before the slowest bounce has leaves balls that tremble, later than in the steps that
// are watched: 3.2e-4 of a weight, where the bounce is taken for half as fast again.
TEST(Pile, IsLeftNoMoreByTheDragThanTheBounceSays) {
  Workload work = settled("pile", 1000);
  go_on(work, 40);
  EXPECT_LT(work.error(), 1.3e-5);  // (1 + ωT) e^(−ωT), ωT = 14
}

TEST_P(EveryFamily, EachBatchOfEachPartDoesTheSameWork) {
  const Workload work = settled(GetParam());
  for (const Timed& timed : timed_parts()) {
    Batch batch(work, timed);
    batch.run();
    const std::uint64_t first = batch.hash();
    for (int k = 0; k < 3; ++k) {
      batch.restore();
      batch.run();
      EXPECT_EQ(batch.hash(), first) << timed.name << ", batch " << k;
    }
  }
}

// Lists that are made anew change places with those of the last time, so both have to grow: where only one
// had, that of 10⁵ contacts on plates read 764 ns each, and 350 once it was measured for long enough.
TEST_P(EveryFamily, OnceWarmABatchAllocatesNothing) {
  const Workload work = settled(GetParam());
  for (const Timed& timed : timed_parts()) {
    if (timed.goes_on()) continue;  // begins with a copy of the workload, off the clock
    Batch batch(work, timed);
    batch.warm();
    const std::uint64_t before = allocations();
    batch.time();
    EXPECT_EQ(allocations() - before, 0U) << timed.name;
  }
}

// What goes on ends where as many steps end that are taken without a clock, batch for batch, with the same
// memory of how far all has moved.
TEST_P(EveryFamily, WhatGoesOnTakesTheStepsThatFollow) {
  const Workload work = settled(GetParam());
  Workload after = work;
  for (int k = 0; k < kStepsInARow; ++k) {
    step(*after.scene, after.options, after.state, after.workspace);
  }
  for (const Timed& timed : timed_parts()) {
    if (timed.phase == Phase::kDepth && !work.scene->pairs_possible) continue;  // no step has it
    Batch batch(work, timed);
    if (!timed.goes_on()) {
      EXPECT_EQ(batch.steps(), 1) << timed.name;
      continue;
    }
    EXPECT_EQ(batch.steps(), kStepsInARow) << timed.name;
    for (int k = 0; k < 2; ++k) {
      const Batch::Seconds seconds = batch.time();
      EXPECT_GT(seconds.cpu, 0.0) << timed.name;
      EXPECT_GT(seconds.wall, 0.0) << timed.name;
      const Workload& now = batch.work();
      EXPECT_EQ(hash_of(now.state), hash_of(after.state)) << timed.name << ", batch " << k;
      EXPECT_EQ(now.workspace.search.path, after.workspace.search.path) << timed.name;
    }
  }
}

// The parts of one step in their order are the step.
TEST_P(EveryFamily, PhasesOneByOneEndWhereTheStepEnds) {
  const Workload work = settled(GetParam());
  const std::vector<Timed> parts = timed_parts();
  const auto part = [&](const std::string& name) {
    return *std::find_if(parts.begin(), parts.end(),
                         [&](const Timed& timed) { return timed.name == name; });
  };
  Batch last(work, part("integrate")), whole(work, part("step"));
  last.run();
  whole.run();
  State by_phases = last.work().state;
  ++by_phases.step;
  EXPECT_EQ(hash_of(by_phases), hash_of(whole.work().state));
}

TEST_P(EveryFamily, TheStepCostsWhatItsPhasesCost) {
  const Workload work = settled(GetParam());
  ModelledCost sum, step;
  for (const Timed& timed : timed_parts()) {
    const ModelledCost cost = modelled_cost(timed, work);
    if (timed.whole_step) {
      step = cost;
    } else if (timed.rule == work.options.rule && !timed.afresh) {
      sum.bytes += cost.bytes;
      sum.flops += cost.flops;
    }
  }
  EXPECT_GT(step.flops, 0.0);
  EXPECT_DOUBLE_EQ(step.bytes, sum.bytes);
  EXPECT_DOUBLE_EQ(step.flops, sum.flops);
}

INSTANTIATE_TEST_SUITE_P(Families, EveryFamily, testing::ValuesIn(family_names()),
                         [](const auto& family) { return family.param; });

TEST(Choose, TakesNamesThatMatchAndRefusesWhatMatchesNone) {
  const std::vector<Chosen> chosen = choose("^friction:none/slab/contacts:1000$", false);
  ASSERT_EQ(chosen.size(), 1u);
  EXPECT_EQ(chosen[0].name, "friction:none/slab/contacts:1000");
  EXPECT_EQ(choose("-slab", false).size() + choose("slab", false).size(), choose("", false).size());
  EXPECT_GT(choose("", true).size(), choose("", false).size());
  EXPECT_THROW(choose("no such thing", false), InputError);
  EXPECT_THROW(choose("(", false), InputError);
}

TEST(Choose, NamesHaveNoSpaces) {
  for (const Chosen& chosen : choose("", true)) {
    EXPECT_EQ(chosen.name.find(' '), std::string::npos) << chosen.name;
  }
}

}  // namespace
}  // namespace stiction::bench
