// SPDX-License-Identifier: BSD-3-Clause
#include "solver/phases/detect_pairs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "solver/feature.h"

namespace stiction {

namespace {

// Round-off of weights of order one: a point on a shared face must not fall between its two
// elements.
constexpr double kOnBoundary = -1e-12;

bool may_touch_itself(const Body& body) {
  return built_in(Feature::kSelfCollision) && body.self_collision;
}

void bound_bodies(const Scene& scene, PairSearch& search) {
  search.box.resize(scene.bodies.size());
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    Eigen::AlignedBox3d box;
    for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v) {
      box.extend(search.predicted[static_cast<std::size_t>(v)]);
    }
    search.box[b] = box;
  }
}

// The part of each body's box in which it can meet another body; empty boxes meet nothing. Sweep
// and prune along x.
void find_overlaps(const Scene& scene, PairSearch& search) {
  const std::size_t count = scene.bodies.size();
  search.overlap.assign(count, Eigen::AlignedBox3d());
  search.order.resize(count);
  std::iota(search.order.begin(), search.order.end(), 0);
  std::sort(search.order.begin(), search.order.end(), [&](int a, int b) {
    const double xa = search.box[static_cast<std::size_t>(a)].min().x();
    const double xb = search.box[static_cast<std::size_t>(b)].min().x();
    return xa != xb ? xa < xb : a < b;
  });
  for (std::size_t i = 0; i < count; ++i) {
    const auto a = static_cast<std::size_t>(search.order[i]);
    if (may_touch_itself(scene.bodies[a]) && !scene.bodies[a].fixed) {
      search.overlap[a].extend(search.box[a]);
    }
    for (std::size_t j = i + 1; j < count; ++j) {
      const auto b = static_cast<std::size_t>(search.order[j]);
      if (search.box[b].min().x() > search.box[a].max().x()) break;
      if (scene.bodies[a].fixed && scene.bodies[b].fixed) continue;
      const Eigen::AlignedBox3d common = search.box[a].intersection(search.box[b]);
      if (common.isEmpty()) continue;
      search.overlap[a].extend(common);
      search.overlap[b].extend(common);
    }
  }
}

void hash_vertices(const Scene& scene, PairSearch& search) {
  search.hash.clear(scene.topology.mean_edge);
  for (const int vertex : scene.surface_vertex) {
    const auto v = static_cast<std::size_t>(vertex);
    const auto body = static_cast<std::size_t>(scene.topology.vertex_body[v]);
    if (search.overlap[body].isEmpty()) continue;
    if (search.overlap[body].contains(search.predicted[v])) {
      search.hash.add(vertex, search.predicted[v]);
    }
  }
  search.hash.build();
}

void test_element(const Scene& scene, std::int32_t e, PairSearch& search) {
  const Element& element = scene.elements[static_cast<std::size_t>(e)];
  const std::int32_t body = scene.topology.element_body[static_cast<std::size_t>(e)];
  const bool self = may_touch_itself(scene.bodies[static_cast<std::size_t>(body)]);
  const bool fixed = scene.bodies[static_cast<std::size_t>(body)].fixed;
  Eigen::AlignedBox3d box;
  const Vec3* corner[4];
  for (int k = 0; k < 4; ++k) {
    corner[k] = &search.predicted[static_cast<std::size_t>(element.vertex[k])];
    box.extend(*corner[k]);
  }
  if (!box.intersects(search.overlap[static_cast<std::size_t>(body)])) return;
  search.hash.for_each_in(
      search.hash.cell(box.min()), search.hash.cell(box.max()), [&](std::int32_t vertex) {
        const auto v = static_cast<std::size_t>(vertex);
        const std::int32_t other = scene.topology.vertex_body[v];
        if (other == body && (!self || std::count(element.vertex, element.vertex + 4, vertex))) {
          return;
        }
        if (fixed && scene.bodies[static_cast<std::size_t>(other)].fixed) return;
        if (!box.contains(search.predicted[v])) return;
        const double deepest =
            barycentric(search.predicted[v], *corner[0], *corner[1], *corner[2], *corner[3])
                .minCoeff();
        if (deepest >= kOnBoundary) {
          search.hits.push_back(
              {contact_key(static_cast<std::uint32_t>(vertex), static_cast<std::uint32_t>(body)), e,
               deepest});
        }
      });
}

void add_contact(ContactKey key, std::int32_t element, std::int32_t triangle, bool open,
                 PairContacts& pairs) {
  PairContact contact;
  contact.open = open;
  contact.key = key;
  contact.vertex = static_cast<std::int32_t>(key >> 32);
  contact.element = element;
  contact.triangle = triangle;
  pairs.push_back(contact);
}

// Merges this step's hits with the contacts of the last step that have only just opened. Those are
// measured in the depth phase, which drops them when the gap is too wide.
void merge_with_kept(const std::vector<PairSearch::Hit>& hits, const PairMemory* last,
                     PairContacts& pairs) {
  pairs.clear();
  std::size_t old = 0;
  for (std::size_t h = 0; h < hits.size(); ++h) {
    if (h > 0 && hits[h].key == hits[h - 1].key) continue;  // the deepest one stands first
    for (; last && old < last->body_key.size() && last->body_key[old] <= hits[h].key; ++old) {
      if (last->body_key[old] != hits[h].key) {
        add_contact(last->body_key[old], last->element[old], last->triangle[old], true, pairs);
      }
    }
    const bool persists = last && old > 0 && last->body_key[old - 1] == hits[h].key;
    add_contact(hits[h].key, hits[h].element, persists ? last->triangle[old - 1] : -1, false,
                pairs);
  }
  for (; last && old < last->body_key.size(); ++old) {
    add_contact(last->body_key[old], last->element[old], last->triangle[old], true, pairs);
  }
}

}  // namespace

Eigen::Vector4d barycentric(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c,
                            const Vec3& d) {
  const Vec3 ab = b - a, ac = c - a, ad = d - a, ap = point - a;
  const Vec3 ac_ad = ac.cross(ad);
  const double volume = ab.dot(ac_ad);
  Eigen::Vector4d weight;
  weight[1] = ap.dot(ac_ad) / volume;
  weight[2] = ab.dot(ap.cross(ad)) / volume;
  weight[3] = ab.dot(ac.cross(ap)) / volume;
  weight[0] = 1.0 - weight[1] - weight[2] - weight[3];
  return weight;
}

void detect_pairs(const Scene& scene, const Options& options, const State& state,
                  Workspace& workspace) {
  PairSearch& search = workspace.search;
  search.predicted.resize(state.position.size());
  for (std::size_t k = 0; k < state.position.size(); ++k) {
    search.predicted[k] = state.position[k].x + options.time_step * workspace.velocity[k].v;
  }
  bound_bodies(scene, search);
  find_overlaps(scene, search);
  hash_vertices(scene, search);
  search.hits.clear();
  if (!search.hash.empty()) {
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      if (search.overlap[b].isEmpty()) continue;
      const Body& body = scene.bodies[b];
      for (int e = body.first_element; e < body.first_element + body.element_count; ++e) {
        test_element(scene, e, search);
      }
    }
  }
  std::sort(search.hits.begin(), search.hits.end(),
            [](const PairSearch::Hit& a, const PairSearch::Hit& b) {
              if (a.key != b.key) return a.key < b.key;
              if (a.deepest != b.deepest) return a.deepest > b.deepest;
              return a.element < b.element;
            });
  const bool keep = options.pairs.hysteresis > 0.0 || options.pairs.tie_margin > 0.0;
  merge_with_kept(search.hits, keep ? &state.pair_memory : nullptr, workspace.pairs);
}

}  // namespace stiction
