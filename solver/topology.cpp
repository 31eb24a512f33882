// SPDX-License-Identifier: BSD-3-Clause
#include "solver/topology.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/scene.h"

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

double mean_edge_length(const Scene& scene) {
  double sum = 0.0;
  for (const Element& element : scene.elements) {
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < a; ++b) {
        sum += (scene.rest_position.col(element.vertex[a]) -
                scene.rest_position.col(element.vertex[b]))
                   .norm();
      }
    }
  }
  return scene.elements.empty() ? 0.0 : sum / (6.0 * static_cast<double>(scene.elements.size()));
}

// Of a tetrahedron: the least of the heights above its faces and of the distances between the lines
// of opposite edges, each six times the volume over an area.
double width(const Scene& scene, const Element& element) {
  const auto x = [&](int k) -> Vec3 { return scene.rest_position.col(element.vertex[k]); };
  const Vec3 a = x(1) - x(0), b = x(2) - x(0), c = x(3) - x(0);
  double area = 0.0;  // twice the largest
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
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    std::fill_n(topology.vertex_body.begin() + body.first_vertex, body.vertex_count,
                static_cast<std::int32_t>(b));
    std::fill_n(topology.element_body.begin() + body.first_element, body.element_count,
                static_cast<std::int32_t>(b));
    topology.body_triangle_begin.push_back(static_cast<std::int32_t>(topology.triangle.size()));
    add_triangles(scene, body, topology);
    double least = std::numeric_limits<double>::infinity();
    for (int e = body.first_element; e < body.first_element + body.element_count; ++e) {
      least = std::min(least, width(scene, scene.elements[static_cast<std::size_t>(e)]));
    }
    topology.least_width.push_back(least);
  }
  topology.body_triangle_begin.push_back(static_cast<std::int32_t>(topology.triangle.size()));
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
