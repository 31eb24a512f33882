// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/real.h"

namespace stiction {

struct Scene;

/// How the scene's tetrahedra hang together; constant for a scene. Only consistent depth needs it,
/// so that it is made when that is first asked for.
struct MeshLinks {
  std::uint64_t scene = 0;  ///< serial number of the scene that it is of; 0: none yet

  /// What lies behind the face opposite each corner of an element: an element, or −1 − t for the
  /// surface triangle t.
  std::vector<std::array<std::int32_t, 4>> behind;

  /// Vertices joined to a vertex by an edge of a tetrahedron, ascending:
  /// neighbour[neighbour_begin[v] … neighbour_begin[v + 1]).
  std::vector<std::int32_t> neighbour_begin;
  std::vector<std::int32_t> neighbour;

  std::span<const std::int32_t> neighbours_of(std::int32_t vertex) const {
    const std::int32_t* const begin = &neighbour_begin[static_cast<std::size_t>(vertex)];
    return {neighbour.data() + begin[0], neighbour.data() + begin[1]};
  }

  std::vector<Real> longest_edge;  ///< per body, at rest, m
};

void build_links(const Scene& scene, MeshLinks& links);

}  // namespace stiction
