// SPDX-License-Identifier: BSD-3-Clause
#include "solver/elasticity/element_shares.h"

#include <algorithm>

#include "solver/parallel/team.h"

namespace stiction {

namespace {

// Where a share begins: a whole block of constants is one share's.
std::size_t border_of(const Scene& scene, std::size_t share, std::size_t count) {
  constexpr std::size_t kBlock = BlocksOfConstants::kBlock;
  if (share == count) return scene.elements.size();
  return range_begin(scene.elements.size(), share, count) / kBlock * kBlock;
}

}  // namespace

void share_elements(const Scene& scene, std::size_t count, ElementShares& shares) {
  if (shares.scene == scene.serial && shares.share.size() == count) return;
  shares.scene = scene.serial;
  shares.share.assign(count, {});
  constexpr std::size_t kNone = ~std::size_t{0};
  std::vector<std::size_t> owner(scene.mass.size(), kNone);
  for (std::size_t s = 0; s < count; ++s) {
    ElementShare& share = shares.share[s];
    share.begin = border_of(scene, s, count);
    share.end = border_of(scene, s + 1, count);
    for (std::size_t e = share.begin; e < share.end; ++e) {
      ElementShare::Border border{e, {}};
      for (int k = 0; k < 4; ++k) {
        const std::int32_t v = scene.elements[e].vertex[k];
        std::size_t& first = owner[static_cast<std::size_t>(v)];
        if (first == kNone) first = s;
        border.shared[k] = first != s;
        if (border.shared[k]) share.vertex.push_back(v);
      }
      if (std::count(border.shared, border.shared + 4, true) > 0) share.border.push_back(border);
    }
    share.force.resize(share.vertex.size());
  }
}

void add_forces_left_aside(const ElementShares& shares, std::vector<Force>& force) {
  for (const ElementShare& share : shares.share) {
    for (std::size_t k = 0; k < share.vertex.size(); ++k) {
      force[static_cast<std::size_t>(share.vertex[k])].f += share.force[k].f;
    }
  }
}

}  // namespace stiction
