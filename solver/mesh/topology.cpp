// SPDX-License-Identifier: BSD-3-Clause
#include "solver/mesh/topology.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include "solver/mesh/numbering.h"
#include "solver/scene/scene.h"

namespace stiction {

namespace {

using Lists = std::vector<std::vector<std::int32_t>>;

void sort_unique(std::vector<std::int32_t>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

// Surface triangles of one body, appended in the order of its elements.
void add_triangles(const Scene& scene, const Body& body, Topology& topology) {
  Eigen::Matrix4Xi corners(4, body.element_count);
  for (int e = 0; e < body.element_count; ++e) {
    const Element& element = scene.elements[static_cast<std::size_t>(body.first_element + e)];
    for (int k = 0; k < 4; ++k) corners(k, e) = element.vertex[k];
  }
  std::vector<Eigen::Index> owners;
  const Eigen::Matrix3Xi triangles = surface_triangles(corners, &owners);
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    topology.triangle.push_back(
        {{triangles(0, t), triangles(1, t), triangles(2, t)},
         body.first_element + static_cast<std::int32_t>(owners[static_cast<std::size_t>(t)])});
  }
}

// Cosine of the angle between the normals at a sharp edge, at most.
const Real kSharp = std::cos(30 * std::numbers::pi / 180);

// Sharp edges of the surface triangles from `first` on, in the order in which they appear.
void add_sharp_edges(const Scene& scene, std::size_t first, Topology& topology) {
  struct Side {
    std::int32_t low, high, opposite;
    std::size_t triangle;
  };
  std::vector<Side> sides;
  for (std::size_t t = first; t < topology.triangle.size(); ++t) {
    const auto& v = topology.triangle[t].vertex;
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(v[k], v[(k + 1) % 3]);
      sides.push_back({low, high, v[(k + 2) % 3], t});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  const auto x = [&](std::int32_t v) -> Vec3 { return scene.rest_position.col(v); };
  const auto normal = [&](std::size_t t) -> Vec3 {
    const auto& v = topology.triangle[t].vertex;
    return (x(v[1]) - x(v[0])).cross(x(v[2]) - x(v[0])).normalized();
  };
  for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
    const Side &one = sides[k], &other = sides[k + 1];
    if (one.low != other.low || one.high != other.high) continue;
    const bool convex = normal(one.triangle).dot(x(other.opposite) - x(one.low)) < 0.0;
    if (!convex || normal(one.triangle).dot(normal(other.triangle)) > kSharp) continue;
    topology.sharp_edge.push_back({{one.low, one.high},
                                   {one.opposite, other.opposite},
                                   topology.triangle[one.triangle].element,
                                   {false, false}});
  }
}

// Notes at which ends the sharp edges go on.
void note_ends(const Scene& scene, Topology& topology) {
  std::vector<std::vector<std::size_t>> at(static_cast<std::size_t>(scene.vertex_count()));
  for (std::size_t e = 0; e < topology.sharp_edge.size(); ++e) {
    for (const std::int32_t v : topology.sharp_edge[e].vertex) {
      at[static_cast<std::size_t>(v)].push_back(e);
    }
  }
  // Unit, away from the end.
  const auto direction = [&](std::size_t e, std::int32_t end) -> Vec3 {
    const auto& v = topology.sharp_edge[e].vertex;
    const std::int32_t other = v[0] == end ? v[1] : v[0];
    return (scene.rest_position.col(other) - scene.rest_position.col(end)).normalized();
  };
  for (std::size_t e = 0; e < topology.sharp_edge.size(); ++e) {
    for (int k = 0; k < 2; ++k) {
      const std::int32_t end = topology.sharp_edge[e].vertex[k];
      for (const std::size_t other : at[static_cast<std::size_t>(end)]) {
        if (direction(e, end).dot(direction(other, end)) < -kSharp) {
          topology.sharp_edge[e].goes_on[k] = true;
        }
      }
    }
  }
}

Real mean_edge_length(const Scene& scene) {
  Real sum = 0.0;
  for (const Element& element : scene.elements) {
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < a; ++b) {
        sum += (scene.rest_position.col(element.vertex[a]) -
                scene.rest_position.col(element.vertex[b]))
                   .norm();
      }
    }
  }
  return scene.elements.empty() ? 0.0 : sum / (6 * static_cast<Real>(scene.elements.size()));
}

// Of a tetrahedron: the least of the heights above its faces and of the distances between the lines
// of opposite edges, each six times the volume over an area.
Real width(const Scene& scene, const Element& element) {
  const auto x = [&](int k) -> Vec3 { return scene.rest_position.col(element.vertex[k]); };
  const Vec3 a = x(1) - x(0), b = x(2) - x(0), c = x(3) - x(0);
  Real area = 0.0;  // twice the largest
  for (const Vec3& twice : {a.cross(b), b.cross(c), c.cross(a), (b - a).cross(c - a),
                            a.cross(c - b), b.cross(c - a), c.cross(b - a)}) {
    area = std::max(area, twice.norm());
  }
  return std::abs(a.cross(b).dot(c)) / area;
}

}  // namespace

Topology build_topology(const Scene& scene) {
  Topology topology;
  const auto vertices = static_cast<std::size_t>(scene.vertex_count());
  topology.vertex_body.resize(vertices);
  topology.element_body.resize(scene.elements.size());
  topology.vertex_place = places_along_curve(scene.rest_position.cast<double>());
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    std::fill_n(topology.vertex_body.begin() + body.first_vertex, body.vertex_count,
                static_cast<std::int32_t>(b));
    std::fill_n(topology.element_body.begin() + body.first_element, body.element_count,
                static_cast<std::int32_t>(b));
    topology.body_triangle_begin.push_back(static_cast<std::int32_t>(topology.triangle.size()));
    const std::size_t first = topology.triangle.size();
    add_triangles(scene, body, topology);
    topology.body_edge_begin.push_back(static_cast<std::int32_t>(topology.sharp_edge.size()));
    add_sharp_edges(scene, first, topology);
    Real least = std::numeric_limits<Real>::infinity();
    for (int e = body.first_element; e < body.first_element + body.element_count; ++e) {
      least = std::min(least, width(scene, scene.elements[static_cast<std::size_t>(e)]));
    }
    topology.least_width.push_back(least);
    topology.thinnest = std::min(topology.thinnest, least);
  }
  topology.body_triangle_begin.push_back(static_cast<std::int32_t>(topology.triangle.size()));
  topology.body_edge_begin.push_back(static_cast<std::int32_t>(topology.sharp_edge.size()));
  note_ends(scene, topology);
  topology.mean_edge = mean_edge_length(scene);

  // Rings: the triangles at each vertex, then those at each vertex's neighbours on the surface.
  Lists ring(vertices);
  for (std::size_t t = 0; t < topology.triangle.size(); ++t) {
    for (const std::int32_t v : topology.triangle[t].vertex) {
      ring[static_cast<std::size_t>(v)].push_back(static_cast<std::int32_t>(t));
    }
  }
  Lists two_rings(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    for (const std::int32_t t : ring[v]) {
      for (const std::int32_t w : topology.triangle[static_cast<std::size_t>(t)].vertex) {
        const auto& others = ring[static_cast<std::size_t>(w)];
        two_rings[v].insert(two_rings[v].end(), others.begin(), others.end());
      }
    }
    sort_unique(two_rings[v]);
  }
  topology.neighbour_begin.push_back(0);
  for (std::size_t v = 0; v < vertices; ++v) {
    std::vector<std::int32_t> joined;
    for (const std::int32_t t : ring[v]) {
      for (const std::int32_t w : topology.triangle[static_cast<std::size_t>(t)].vertex) {
        if (static_cast<std::size_t>(w) != v) joined.push_back(w);
      }
    }
    sort_unique(joined);
    topology.neighbour.insert(topology.neighbour.end(), joined.begin(), joined.end());
    topology.neighbour_begin.push_back(static_cast<std::int32_t>(topology.neighbour.size()));
  }
  topology.near_begin.push_back(0);
  std::vector<std::int32_t> near;
  for (const Element& element : scene.elements) {
    near.clear();
    for (const std::int32_t v : element.vertex) {
      const auto& list = two_rings[static_cast<std::size_t>(v)];
      near.insert(near.end(), list.begin(), list.end());
    }
    sort_unique(near);
    topology.near.insert(topology.near.end(), near.begin(), near.end());
    topology.near_begin.push_back(static_cast<std::int32_t>(topology.near.size()));
  }
  return topology;
}

}  // namespace stiction
