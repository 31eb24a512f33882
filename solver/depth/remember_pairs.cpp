// SPDX-License-Identifier: BSD-3-Clause
#include "solver/depth/remember_pairs.h"

#include <atomic>
#include <cstdint>

namespace stiction {

namespace {

// In mean edges: an excess below the rounding of a position.
constexpr Real kNothing = round_off(1e-15);

}  // namespace

void remember_pairs(PairContacts& pairs, const Topology& topology, PairGeometry& memory,
                    const Team* team) {
  static std::atomic<std::uint64_t> last_serial = 0;
  const bool known = pairs.remembered != 0 && pairs.remembered == memory.serial;
  if (!known) {
    memory.body_key.resize(pairs.size());
    memory.element.resize(pairs.size());
    memory.triangle.resize(pairs.size());
  }
  memory.excess.clear();
  // Few steps have any excess, and many where the lists are known no other triangle.
  std::atomic<bool> any_excess = false, any_change = !known;
  for_ranges(team, pairs.size(), kContactsToShare, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      const PairSite& site = pairs.site(c);
      if (site.excess > kNothing * topology.mean_edge) any_excess = true;
      if (!known) {
        const std::int32_t body = topology.element_body[static_cast<std::size_t>(site.element)];
        memory.body_key[c] = contact_key(pairs[c].vertex, body);
        memory.element[c] = site.element;
        memory.triangle[c] = site.triangle;
      } else if (memory.triangle[c] != site.triangle || memory.element[c] != site.element) {
        memory.triangle[c] = site.triangle;
        memory.element[c] = site.element;
        any_change = true;
      }
    }
  });
  if (any_change) pairs.remembered = memory.serial = ++last_serial;
  for (std::size_t c = 0; any_excess && c < pairs.size(); ++c) {
    const Real excess = pairs.site(c).excess;
    if (excess > kNothing * topology.mean_edge) {
      memory.excess.push_back({memory.body_key[c], excess});
    }
  }
}

}  // namespace stiction
