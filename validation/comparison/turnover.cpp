// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/turnover.h"

#include <algorithm>
#include <utility>

namespace stiction {

void Turnover::add(const std::vector<ContactSample>& contacts) {
  std::vector<Touch> now;
  for (const ContactSample& contact : contacts) {
    if (contact.normal_force == 0.0) continue;
    now.push_back({static_cast<std::int64_t>(contact.obstacle), contact.against_body ? 1 : 0,
                   contact.point, contact.facet});
  }
  std::sort(now.begin(), now.end());
  const auto same_point = [](const Touch& a, const Touch& b) {
    return std::equal(a.begin(), a.begin() + 3, b.begin());
  };
  auto next = now.begin();
  for (const Touch& before : last_) {
    while (next != now.end() && *next < before && !same_point(*next, before)) ++next;
    if (next == now.end() || !same_point(*next, before)) {
      ++losses_;
    } else if ((*next)[3] != before[3]) {
      ++facet_changes_;
    }
  }
  loaded_ += now.size();
  ++steps_;
  last_ = std::move(now);
}

double Turnover::mean_loaded() const {
  return steps_ > 0 ? static_cast<double>(loaded_) / static_cast<double>(steps_) : 0.0;
}

}  // namespace stiction
