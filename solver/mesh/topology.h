// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "solver/mesh/mesh.h"
#include "solver/real.h"

namespace stiction {

/// What two-sided contact needs to know of the scene's surfaces; constant. Empty when the scene has
/// no pair of bodies that could touch.
struct Topology {
  struct Triangle {
    std::int32_t vertex[3];  ///< counter-clockwise from outside
    std::int32_t element;    ///< whose face it is
  };
  std::vector<Triangle> triangle;          ///< surface triangles, body by body
  std::vector<std::int32_t> element_body;  ///< body of each element
  std::vector<std::int32_t> vertex_body;   ///< body of each vertex
  /// Place of each vertex along a curve through all bodies at rest: neighbours, of whichever body they
  /// are, have places near each other.
  std::vector<std::int32_t> vertex_place;
  /// Triangles to which a point inside an element can be nearest: all within two rings around the
  /// element's corners. near[near_begin[e] … near_begin[e + 1]); empty for elements deep inside,
  /// whose points are compared with every triangle of the body.
  std::vector<std::int32_t> near_begin;
  std::vector<std::int32_t> near;
  std::vector<std::int32_t> body_triangle_begin;  ///< first triangle of each body, and one past all
  /// Surface vertices joined to a vertex by an edge of the surface.
  std::vector<std::int32_t> neighbour_begin;
  std::vector<std::int32_t> neighbour;
  /// An edge of the surface at which a body is convex by 30° or more at rest.
  struct SharpEdge {
    std::int32_t vertex[2];
    std::int32_t opposite[2];  ///< third vertices of the two triangles there
    std::int32_t element;      ///< one that has the edge
    bool goes_on[2];           ///< another sharp edge goes on there within 30° of straight on
  };
  std::vector<SharpEdge> sharp_edge;          ///< body by body
  std::vector<std::int32_t> body_edge_begin;  ///< first sharp edge of each body, and one past all
  Real mean_edge = 0.0;                       ///< of all elements, m: the cell of the hash
  /// Per body: the least width of its elements at rest, m; infinite where it has none. The hat
  /// functions of any of an element's corners fall from 1 to 0 within no less. So from a point of
  /// an element e to a triangle that shares no corner with e it is at least as far.
  std::vector<Real> least_width;
  Real thinnest = std::numeric_limits<Real>::infinity();  ///< the least of all bodies, m
};

struct Scene;

/// Builds it from the scene's elements.
Topology build_topology(const Scene& scene);

}  // namespace stiction
