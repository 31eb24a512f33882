// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <limits>

namespace stiction {

/// The triangles through which the edges of a vertex can leave the body that it is in: through no others
/// while it is in the same element and the paths of both bodies together are below `until`, m.
struct alignas(64) Outlets {
  static constexpr int kMost = 13;       ///< triangles; what has more is not known
  static constexpr int kMostEdges = 32;  ///< of a vertex; the same

  /// Edges are a bit each, in the order of MeshLinks::neighbour.
  struct Outlet {
    std::int32_t triangle;
    std::uint32_t edges;  ///< that can leave there
  };
  double until = -std::numeric_limits<double>::infinity();
  std::int32_t element = -1;     ///< that the vertex was in
  std::uint32_t may_end_in = 0;  ///< edges that may end in the body
  std::int8_t steps = 0;         ///< in a row in that element, since it was last asked for how long
  std::int8_t count = 0;         ///< of outlets
  std::array<Outlet, kMost> outlet = {};
};
static_assert(sizeof(Outlets) == 128);

}  // namespace stiction
