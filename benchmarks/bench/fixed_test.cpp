// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/bench/fixed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "benchmarks/bench/allocations.h"
#include "benchmarks/bench/batch.h"
#include "solver/demand.h"
#include "solver/hash.h"
#include "solver/step.h"

namespace stiction::bench {
namespace {

TEST(Fixed, DoesExactlySoManyBatchesOfTheSameWork) {
  const auto one = nlohmann::json::parse(run_fixed("friction:stored-vector/slab/contacts:1000", 1));
  const auto three =
      nlohmann::json::parse(run_fixed("friction:stored-vector/slab/contacts:1000", 3));
  EXPECT_EQ(one["batches"], 1);
  EXPECT_EQ(one["contact_updates"], one["contacts"]);
  EXPECT_EQ(three["contact_updates"], 3 * one["contacts"].get<int>());
  EXPECT_EQ(three["hash"], one["hash"]);
  EXPECT_EQ(three["allocations"], 0) << "a warm step allocates nothing";
  EXPECT_LT(one["error"], 7e-3) << "the tolerance of the workload's checks";
}

TEST(Fixed, StepsGoOn) {
  for (const WorkloadFamily& family : family_catalog()) {
    const std::string name =
        "steps:32/" + family.name + "/contacts:" + std::to_string(family.sizes.front());
    const auto two = nlohmann::json::parse(run_fixed(name, 2));
    Workload work = settle(family, family.sizes.front());
    std::size_t updates = 0;
    for (int k = 0; k < 2 * kStepsInARow; ++k) {
      step(*work.scene, work.options, work.state, work.workspace);
      updates += work.contacts();
    }
    EXPECT_EQ(two["hash"], hash_of(work.state) & 0xffffffffu) << name;
    EXPECT_EQ(two["contact_updates"], updates) << name;
    EXPECT_GT(updates, 0u) << name;
  }
}

TEST(Fixed, RefusesAnUnknownName) {
  EXPECT_THROW(run_fixed("friction:none/slab/contacts:7", 1), InputError);
}

TEST(Fixed, EachRuleAndPhaseHasAName) {
  const std::vector<std::string> names = fixed_names();
  for (const char* name : {"detect/slab/contacts:1000", "friction:secant/slab/contacts:1000",
                           "step/slab/contacts:1000", "steps:32/flush/contacts:100"}) {
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  }
}

struct alignas(64) Wide {
  double value[8];
};

TEST(Allocations, AreCounted) {
  const std::uint64_t before = allocations();
  const auto kept = std::make_unique<int>(1);
  const auto aligned = std::make_unique<Wide>();
  EXPECT_GE(allocations() - before, 2u);
}

}  // namespace
}  // namespace stiction::bench
