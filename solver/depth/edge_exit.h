// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "solver/lanes/lane_matrix.h"
#include "solver/mesh/mesh_links.h"
#include "solver/scene/scene.h"

namespace stiction {

/// The planes of a tetrahedron's four faces side by side: of the face opposite corner k in lane k.
/// Aligned as where registers are so wide, whoever keeps it.
struct alignas(4 * sizeof(Real)) FacePlanes {
  using Four = Lanes<4 * sizeof(Real)>;
  LaneVector<Four> on;      ///< a corner of the face, m
  LaneVector<Four> normal;  ///< outward, m²
  Four length;              ///< of the normal, m²
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

/// Where the segment p → q leaves a body.
struct Exit {
  Real t = 0.0;                ///< x_e = p + t (q − p), in [0, 1], dimensionless
  Vec3 normal = Vec3::Zero();  ///< n_e, outward, unit
};

/// Finds where the segment p → q, with p in the tetrahedron `element`, first leaves the body of
/// that tetrahedron; false if q is inside, or beyond the surface by no more than `thin`, m.
///
///   x_e on the triangle T with  h_T(p) ≤ thin < h_T(q),  t = max(0, −h_T(p)/(h_T(q) − h_T(p)))
///
/// h_T is the height above T's plane. The walk visits every tetrahedron that comes within `thin` of
/// the segment up to x_e, each by its neighbours, so that its cost is the number of those, whatever
/// the size of the body, and no edge or corner that the segment runs through or along stops it.
///
/// Where the segment passes within `thin` of an edge or a corner of the surface that is one
/// crossing: n_e is the mean over the triangles that it leaves through there, weighted by their
/// angles around the point, which doesn't depend on how a face is cut into triangles
/// [ThuermerWuethrich1998]. Whether a line passes on one side of an edge is decided alike for the
/// two triangles of the edge, so that it can't slip between them.
bool find_exit(const Scene& scene, const MeshLinks& links, const std::vector<Vec3>& x,
               const Vec3& p, const Vec3& q, std::int32_t element, Real thin, WalkScratch& scratch,
               Exit& exit);

}  // namespace stiction
