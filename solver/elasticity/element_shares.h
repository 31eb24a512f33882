// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/scene/scene.h"
#include "solver/state.h"

namespace stiction {

/// A range of elements, and where it puts forces on vertices that an earlier range touches too.
struct ElementShare {
  /// An element with such corners.
  struct Border {
    std::size_t element;
    bool shared[4];  ///< which of its corners
  };
  std::size_t begin = 0, end = 0;    ///< elements
  std::vector<Border> border;        ///< in the order of the elements
  std::vector<std::int32_t> vertex;  ///< of the shared corners, in the order …
  std::vector<Force> force;          ///< … in which their forces come, N
};

/// Ranges that threads can go through side by side, for one scene. Each vertex belongs to the first
/// range that touches it, which adds forces there; later ones leave theirs aside, to be added behind,
/// range by range. So each vertex has its forces added in the order of the elements: the same bits
/// for any number of ranges.
struct ElementShares {
  std::uint64_t scene = 0;  ///< serial number of the scene that they are of
  std::vector<ElementShare> share;
};

/// Makes `shares` that many ranges of the scene's elements, ≥ 1, or leaves them if that is what
/// they are.
void share_elements(const Scene& scene, std::size_t count, ElementShares& shares);

/// Adds what the ranges have left aside.
void add_forces_left_aside(const ElementShares& shares, std::vector<Force>& force);

}  // namespace stiction
