// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/bench/fixed.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "benchmarks/bench/allocations.h"
#include "benchmarks/bench/batch.h"
#include "solver/demand.h"
#include "solver/hash.h"
#include "solver/step.h"

namespace stiction::bench {

namespace {

constexpr const char* kFamily = "slab";
constexpr int kContacts = 1000;

WorkloadFamily family_of(const std::string& name) {
  const std::vector<WorkloadFamily> families = family_catalog();
  const auto at = std::find_if(families.begin(), families.end(),
                               [&](const WorkloadFamily& family) { return family.name == name; });
  demand(at != families.end(), "the fixed benchmarks' family is in the catalog");
  return *at;
}

Workload settled(const WorkloadFamily& family, int contacts) {
  Workload work = settle(family, contacts);
  for (const Judgement& check : work.checks) {
    if (check.verdict == Verdict::kPass) continue;
    throw std::runtime_error(fmt::format("the workload is not at rest: {} is {:.3g}",
                                         check.claim.quantity, check.value));
  }
  return work;
}

// "steps:32/flush/contacts:100"
std::string name_of_steps(const WorkloadFamily& family) {
  return fmt::format("steps:{}/{}/contacts:{}", kStepsInARow, family.name, family.sizes.front());
}

// What was done.
struct Done {
  std::size_t contacts;
  std::uint64_t contact_updates, sweeps, allocations, hash;
  double error;
};

Done repeat(const Timed& timed, int batches) {
  const Workload workload = settled(family_of(kFamily), kContacts);
  Batch batch(workload, timed);
  // Twice before, once for each of the buffers that friction exchanges: what the first batches
  // allocate is no part of the cost of one.
  for (int k = 0; k < 2; ++k) {
    batch.run();
    batch.restore();
  }
  std::uint64_t updates = 0;
  const std::uint64_t before = allocations(), sweeps = batch.work().workspace.sweeps;
  for (int k = 0; k < batches; ++k) {
    batch.run();
    updates += batch.work().contacts();
    if (k + 1 < batches) batch.restore();
  }
  const std::uint64_t allocated = allocations() - before;
  const Workload& work = batch.work();
  return {work.contacts(), updates,      work.workspace.sweeps - sweeps,
          allocated,       batch.hash(), work.error()};
}

Done go_on_for(const WorkloadFamily& family, int batches) {
  Workload work = settled(family, family.sizes.front());
  std::uint64_t updates = 0;
  const std::uint64_t before = allocations(), sweeps = work.workspace.sweeps;
  for (int k = 0; k < batches * kStepsInARow; ++k) {
    step(*work.scene, work.options, work.state, work.workspace);
    updates += work.contacts();
  }
  const std::uint64_t allocated = allocations() - before;
  return {work.contacts(),     updates,     work.workspace.sweeps - sweeps, allocated,
          hash_of(work.state), work.error()};
}

Done do_fixed(const std::string& name, int batches) {
  for (const Timed& timed : timed_parts()) {
    if (benchmark_name(timed, kFamily, kContacts) == name) return repeat(timed, batches);
  }
  for (const WorkloadFamily& family : family_catalog()) {
    if (name_of_steps(family) == name) return go_on_for(family, batches);
  }
  throw InputError("there is no fixed benchmark '" + name + "'; --list-fixed shows them all");
}

}  // namespace

std::vector<std::string> fixed_names() {
  std::vector<std::string> names;
  for (const Timed& timed : timed_parts()) {
    names.push_back(benchmark_name(timed, kFamily, kContacts));
  }
  for (const WorkloadFamily& family : family_catalog()) names.push_back(name_of_steps(family));
  return names;
}

std::string run_fixed(const std::string& name, int batches) {
  const Done done = do_fixed(name, batches);
  return nlohmann::ordered_json{{"name", name},
                                {"batches", batches},
                                {"contacts", done.contacts},
                                {"contact_updates", done.contact_updates},
                                {"sweeps", done.sweeps},
                                {"allocations", done.allocations},
                                {"hash", done.hash & 0xffffffffu},
                                {"error", done.error}}
      .dump();
}

}  // namespace stiction::bench
