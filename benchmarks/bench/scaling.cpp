// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/bench/scaling.h"

#include <algorithm>

#include "solver/options.h"

namespace stiction::bench {

namespace {

// A fit of two points has no interval.
constexpr std::size_t kFewest = 3;

Scaling* find(std::vector<Scaling>& all, const std::string& family, const std::string& part) {
  const auto at = std::find_if(all.begin(), all.end(), [&](const Scaling& scaling) {
    return scaling.family == family && scaling.part == part;
  });
  return at == all.end() ? nullptr : &*at;
}

// Appends the sum of two parts where both were measured at the same sizes.
void add_sum(std::vector<Scaling>& all, const std::string& family, const std::string& a,
             const std::string& b) {
  const Scaling* const first = find(all, family, a);
  const Scaling* const second = find(all, family, b);
  if (first == nullptr || second == nullptr || first->contacts != second->contacts) return;
  Scaling sum = *first;
  sum.part = a + " + " + b;
  for (std::size_t k = 0; k < sum.seconds.size(); ++k) sum.seconds[k] += second->seconds[k];
  all.push_back(std::move(sum));
}

}  // namespace

std::vector<Scaling> scalings(const std::vector<Result>& results) {
  std::vector<Scaling> all;
  std::vector<std::string> families;
  for (const Result& result : results) {
    const std::string& family = result.chosen.family.name;
    if (std::find(families.begin(), families.end(), family) == families.end()) {
      families.push_back(family);
    }
    Scaling* known = find(all, family, result.chosen.timed.name);
    if (known == nullptr) {
      all.push_back({family, result.chosen.timed.name, {}, {}, {}});
      known = &all.back();
    }
    known->contacts.push_back(result.contacts);
    known->seconds.push_back(result.seconds);
  }
  for (const std::string& family : families) {
    add_sum(all, family, "detect", "depth");
    add_sum(all, family, "normal-force", std::string("friction:") + kTimedRule);
  }
  std::erase_if(all, [](const Scaling& scaling) { return scaling.contacts.size() < kFewest; });
  std::stable_sort(all.begin(), all.end(),
                   [](const Scaling& a, const Scaling& b) { return a.family < b.family; });
  for (Scaling& scaling : all) {
    scaling.law = reference::fit_power_law(scaling.contacts, scaling.seconds);
  }
  return all;
}

}  // namespace stiction::bench
