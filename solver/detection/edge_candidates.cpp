// SPDX-License-Identifier: BSD-3-Clause
#include "solver/detection/edge_candidates.h"

#include <algorithm>

namespace stiction {

void find_edge_candidates(const Scene& scene, PairSearch& search) {
  const Topology& topology = scene.topology;
  search.edges_listed = true;
  search.edge_candidate.clear();
  search.edge_awake.steps = 0;
  search.edge_box.clear();
  for (std::size_t e = 0; e < topology.sharp_edge.size(); ++e) {
    const Topology::SharpEdge& edge = topology.sharp_edge[e];
    const auto body =
        static_cast<std::size_t>(topology.vertex_body[static_cast<std::size_t>(edge.vertex[0])]);
    if (search.overlap[body].isEmpty()) continue;
    Box3 box(search.reference[static_cast<std::size_t>(edge.vertex[0])]);
    box.extend(search.reference[static_cast<std::size_t>(edge.vertex[1])]);
    box.min().array() -= 2 * search.skin;
    box.max().array() += 2 * search.skin;
    if (!box.intersects(search.overlap[body])) continue;
    search.edge_box.push_back({box, static_cast<std::int32_t>(e), static_cast<std::int32_t>(body)});
  }
  auto& boxes = search.edge_box;
  std::sort(boxes.begin(), boxes.end(), [](const auto& a, const auto& b) {
    const Real xa = a.box.min().x(), xb = b.box.min().x();
    return xa != xb ? xa < xb : a.edge < b.edge;
  });
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      if (boxes[j].box.min().x() > boxes[i].box.max().x()) break;
      if (boxes[i].body == boxes[j].body || !boxes[i].box.intersects(boxes[j].box)) continue;
      if (scene.bodies[static_cast<std::size_t>(boxes[i].body)].fixed &&
          scene.bodies[static_cast<std::size_t>(boxes[j].body)].fixed) {
        continue;
      }
      // Edges are numbered body by body.
      const bool in_order = boxes[i].edge < boxes[j].edge;
      const auto &a = boxes[in_order ? i : j], &b = boxes[in_order ? j : i];
      search.edge_candidate.push_back({.key = contact_key(a.edge, b.edge),
                                       .body_a = static_cast<std::uint32_t>(a.body),
                                       .body_b = static_cast<std::uint32_t>(b.body)});
    }
  }
  std::sort(search.edge_candidate.begin(), search.edge_candidate.end(),
            [](const auto& a, const auto& b) { return a.key < b.key; });
}

}  // namespace stiction
