// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/lanes/lane_matrix.h"

namespace stiction {

/// The planes of a tetrahedron's four faces side by side: of the face opposite corner k in lane k.
/// Aligned as where registers are so wide, whoever keeps it.
struct alignas(4 * sizeof(Real)) FacePlanes {
  using Four = Lanes<4 * sizeof(Real)>;
  LaneVector<Four> on;      ///< a corner of the face, m
  LaneVector<Four> normal;  ///< outward, m²
  Four length;              ///< of the normal, m²

  /// Above the planes, times the lengths of their normals, m³.
  STICTION_LANES_INLINE Four height(const Vec3& x) const {
    return dot(normal, LaneVector<Four>{Four(x.x()), Four(x.y()), Four(x.z())} - on);
  }
};

/// … and of a surface triangle.
struct TrianglePlane {
  Vec3 normal;     ///< outward, m²
  Vec3 unit;       ///< the normal over its length
  Real length[4];  ///< of its edges, m, and of the normal, m²
};

/// Scratch memory of walks.
struct WalkScratch {
  struct Hit {
    Real t;       ///< on the segment, dimensionless
    Vec3 normal;  ///< of the triangle, unit
    Real angle;   ///< of the triangle around the point, rad
  };
  std::vector<std::uint64_t> visited;  ///< per element: the last walk that came by
  std::uint64_t walk = 0;
  std::vector<FacePlanes> planes;          ///< per element, at …
  std::vector<std::uint64_t> planes_at;    ///< … these positions
  std::vector<TrianglePlane> triangle;     ///< per surface triangle, at …
  std::vector<std::uint64_t> triangle_at;  ///< … these
  std::uint64_t positions = 0;             ///< number of times that they have changed
  std::vector<std::int32_t> stack;
  std::vector<Hit> hit;

  /// Before the first walk at new positions, or in another scene, with so many elements and surface
  /// triangles.
  void begin(std::size_t elements, std::size_t triangles);
};

}  // namespace stiction
