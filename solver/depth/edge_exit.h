// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "solver/depth/edge_walk.h"

namespace stiction {

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

/// The tetrahedron that a vertex is in, or beyond by no more than `border.thin`: `border.element`, or what a straight
/// walk comes to from the middle of that; `border.element` if the walk leads out of the body.
std::int32_t element_at(const Border& border, WalkScratch& scratch);

}  // namespace stiction
