// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/bench/fixed.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "benchmarks/bench/allocations.h"
#include "benchmarks/bench/batch.h"
#include "solver/demand.h"

namespace stiction::bench {

namespace {

constexpr const char* kFamily = "slab";
constexpr int kContacts = 1000;

Workload settled() {
  const std::vector<WorkloadFamily> families = family_catalog();
  const auto at = std::find_if(families.begin(), families.end(),
                               [](const WorkloadFamily& family) { return family.name == kFamily; });
  demand(at != families.end(), "the fixed benchmarks' family is in the catalog");
  Workload work = settle(*at, kContacts);
  for (const Judgement& check : work.checks) {
    if (check.verdict == Verdict::kPass) continue;
    throw std::runtime_error(fmt::format("the workload is not at rest: {} is {:.3g}",
                                         check.claim.quantity, check.value));
  }
  return work;
}

}  // namespace

std::vector<std::string> fixed_names() {
  std::vector<std::string> names;
  for (const Timed& timed : timed_parts()) {
    names.push_back(benchmark_name(timed, kFamily, kContacts));
  }
  return names;
}

std::string run_fixed(const std::string& name, int batches) {
  const std::vector<Timed> parts = timed_parts();
  const auto timed = std::find_if(parts.begin(), parts.end(), [&](const Timed& part) {
    return benchmark_name(part, kFamily, kContacts) == name;
  });
  if (timed == parts.end()) {
    throw InputError("there is no fixed benchmark '" + name + "'; --list-fixed shows them all");
  }
  const Workload workload = settled();
  Batch batch(workload, *timed);
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
  return nlohmann::ordered_json{{"name", name},
                                {"batches", batches},
                                {"contacts", batch.work().contacts()},
                                {"contact_updates", updates},
                                {"sweeps", batch.work().workspace.sweeps - sweeps},
                                {"allocations", allocated},
                                {"hash", batch.hash() & 0xffffffffu},
                                {"error", batch.work().error()}}
      .dump();
}

}  // namespace stiction::bench
