// SPDX-License-Identifier: BSD-3-Clause
#include "solver/mesh/mesh_links.h"

#include <algorithm>
#include <utility>

#include "solver/scene/scene.h"

namespace stiction {

namespace {

struct OwnedFace {
  std::array<std::int32_t, 3> corner;  // ascending
  std::int32_t owner;  // 4 × element + opposite corner, or −1 − surface triangle
};

OwnedFace sorted_face(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t owner) {
  OwnedFace face{{a, b, c}, owner};
  std::sort(face.corner.begin(), face.corner.end());
  return face;
}

// A face is one of two elements, or of one element and the surface.
void link_faces(const Scene& scene, MeshLinks& links) {
  std::vector<OwnedFace> faces;
  for (std::size_t e = 0; e < scene.elements.size(); ++e) {
    const auto& v = scene.elements[e].vertex;
    for (int k = 0; k < 4; ++k) {
      faces.push_back(sorted_face(v[(k + 1) % 4], v[(k + 2) % 4], v[(k + 3) % 4],
                                  4 * static_cast<std::int32_t>(e) + k));
    }
  }
  for (std::size_t t = 0; t < scene.topology.triangle.size(); ++t) {
    const auto& v = scene.topology.triangle[t].vertex;
    faces.push_back(sorted_face(v[0], v[1], v[2], -1 - static_cast<std::int32_t>(t)));
  }
  std::sort(faces.begin(), faces.end(), [](const OwnedFace& a, const OwnedFace& b) {
    return a.corner != b.corner ? a.corner < b.corner : a.owner < b.owner;
  });
  links.behind.assign(scene.elements.size(), {});
  const auto link = [&](std::int32_t from, std::int32_t to) {
    if (from < 0) return;
    links.behind[static_cast<std::size_t>(from / 4)][static_cast<std::size_t>(from % 4)] =
        to < 0 ? to : to / 4;
  };
  // In a ring, so that a face of three elements, which no solid has, leads on as well.
  for (std::size_t begin = 0, end; begin < faces.size(); begin = end) {
    end = begin + 1;
    while (end < faces.size() && faces[end].corner == faces[begin].corner) ++end;
    for (std::size_t k = begin; k < end; ++k) {
      link(faces[k].owner, faces[k + 1 < end ? k + 1 : begin].owner);
    }
  }
}

void link_vertices(const Scene& scene, MeshLinks& links) {
  std::vector<std::pair<std::int32_t, std::int32_t>> ends;
  for (const Element& element : scene.elements) {
    for (const std::int32_t a : element.vertex) {
      for (const std::int32_t b : element.vertex) {
        if (a != b) ends.emplace_back(a, b);
      }
    }
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  links.neighbour_begin.assign(static_cast<std::size_t>(scene.vertex_count()) + 1, 0);
  links.neighbour.clear();
  for (const auto& [a, b] : ends) {
    ++links.neighbour_begin[static_cast<std::size_t>(a) + 1];
    links.neighbour.push_back(b);
  }
  for (std::size_t v = 1; v < links.neighbour_begin.size(); ++v) {
    links.neighbour_begin[v] += links.neighbour_begin[v - 1];
  }
}

void measure_edges(const Scene& scene, MeshLinks& links) {
  links.longest_edge.assign(scene.bodies.size(), 0.0);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v) {
      for (const std::int32_t w : links.neighbours_of(v)) {
        const Real length = (scene.rest_position.col(w) - scene.rest_position.col(v)).norm();
        links.longest_edge[b] = std::max(links.longest_edge[b], length);
      }
    }
  }
}

}  // namespace

void build_links(const Scene& scene, MeshLinks& links) {
  link_faces(scene, links);
  link_vertices(scene, links);
  measure_edges(scene, links);
  links.scene = scene.serial;
}

}  // namespace stiction
