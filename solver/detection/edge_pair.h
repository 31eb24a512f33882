// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "solver/mesh/topology.h"
#include "solver/workspace.h"

namespace stiction {

/// Sine of the least angle between edges that cross.
inline constexpr Real kParallel = 0.087;

using EdgeCrossing = PairSearch::EdgeCrossing;

/// A sharp edge as it lies.
struct EdgeFrame {
  Real length;   ///< m
  Vec3 into[2];  ///< in the faces beside it, across it and inwards, unit
};

/// Positions `x` per vertex, m, here and below.
EdgeFrame frame_of(const std::vector<Vec3>& x, const Topology::SharpEdge& edge);

/// How far a crossing must be from an edge's end, m, where the edge goes on and where it does not.
struct EndMargins {
  Real joint, corner;
};

/// How far the crossing lies beyond such margins of one edge, m; negative outside.
Real inside_ends(const Topology::SharpEdge& edge, Real length, Real along,
                 const EndMargins& margins);

/// The lines of two edges.
struct LinePair {
  Vec3 between;  ///< from the first end of a to that of b, m
  Vec3 across;   ///< (edge a) × (edge b), m²
  Real across2;  ///< its square, m⁴
};

/// Whether the edges can cross as far as their lines tell, and where: not parallel, not far beyond
/// their ends.
bool meet(const Topology& topology, const std::vector<Vec3>& x, std::int32_t a, std::int32_t b,
          LinePair& lines, EdgeCrossing& crossing);

/// … and as far as the faces beside them tell: a plane across both edges has each body's two faces on
/// its own side, as far as surfaces that bend allow.
bool face(const LinePair& lines, const EdgeFrame& a, const EdgeFrame& b, EdgeCrossing& crossing);

/// Whether two sharp edges can touch as they lie, and how: they meet, and face each other (the arcs of
/// their normals cross, a face of the Minkowski difference). Edges less than 5° from parallel don't.
bool crossing_of(const Topology& topology, const std::vector<Vec3>& x, std::int32_t a,
                 std::int32_t b, EdgeCrossing& crossing);

/// How far the vertices of both bodies may move, those of one as far as δₐ, of the other as far as δ_b,
/// δₐ + δ_b, m, while two edges can't touch between such ends for the reason that they can't now:
/// they are parallel, cross beyond an end, don't face each other, or do at more than `gap`, m. 0 or less
/// where none of them is sure.
Real apart_within(const Topology& topology, const std::vector<Vec3>& x, std::int32_t a,
                  std::int32_t b, const EndMargins& margins, Real gap);

}  // namespace stiction
